// What the reader has to know while there is nothing to see: compiling, busy, connection lost.

export class Message {
  constructor(element) {
    this.node = document.createElement("div");
    this.node.className = "gasbox-message";
    this.node.setAttribute("role", "status");
    this.node.hidden = true;
    element.append(this.node);
  }

  show(message) {
    const text = wording(message);
    this.node.textContent = text;
    this.node.hidden = text === "";
  }
}

function wording({ kind, ...rest }) {
  switch (kind) {
    case "preparing":
      return rest.first
        ? `Compiling for this machine, only at the first start: ${rest.done} of ${rest.total}`
        : "Getting ready";
    case "busy":
      return `All ${rest.places} places of this lab are taken. This page goes on by itself as soon as one is free.`;
    case "lost":
      return "The connection is lost. Trying again.";
    case "gone":
      return "This page is no longer known to the lab. Please load it again.";
    case "trouble":
      return rest.text;
    default:
      return "";
  }
}
