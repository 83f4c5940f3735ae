// The WebSocket to the server, opened anew when it breaks.

const LARGEST = 16 * 2 ** 20;

export class Connection {
  constructor(onMessage, onFile, onState) {
    Object.assign(this, { onMessage, onFile, onState });
    this.open();
  }

  open() {
    const address = new URL("play", location.href);
    address.protocol = location.protocol === "https:" ? "wss:" : "ws:";
    address.search = address.hash = "";
    this.socket = new WebSocket(address);
    this.socket.binaryType = "arraybuffer";
    this.socket.onopen = () => this.onState(true);
    this.socket.onclose = ({ reason }) => {
      this.onState(false, reason);
      setTimeout(() => this.open(), 1500);
    };
    this.socket.onmessage = ({ data }) => {
      if (typeof data === "string") this.onMessage(JSON.parse(data));
      else this.onFile(data);
    };
  }

  send(message) {
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  // Returns whether the file was small enough to be sent.
  sendFile(content) {
    if (content.byteLength > LARGEST) return false;
    if (this.socket.readyState === WebSocket.OPEN) this.socket.send(content);
    return true;
  }
}
