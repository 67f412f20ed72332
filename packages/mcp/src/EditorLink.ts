import WebSocket from 'ws';
import type { AgentMessage, Content, ToolResult } from './tools';

/** Address of a dev server, and the key with which agents connect. */
export interface EditorPlace {
  /** Address of the dev server, such as http://127.0.0.1:5173/. */
  readonly url: string;
  readonly key: string;
}

/** The editor's answer to a call. */
export interface Answer {
  readonly content: readonly Content[];
  readonly isError?: boolean;
}

/** Time limit of a call (ms). */
const PATIENCE = 120_000;

/** Maximum size of an answer (bytes), enough for a scene as text. */
const MOST_BYTES = 64e6;

const NOT_ALLOWED =
  'The user does not let an agent edit now. Ask them to open the editor and choose “File > Let an agent edit…”, then try again.';

/** Connection to the editor through the dev server; opened by the first call, and reopened after a loss. */
export class EditorLink {
  /** Name of the client, displayed by the editor. */
  name = 'An agent';
  private socket: Promise<WebSocket> | null = null;
  private count = 0;
  private readonly waiting = new Map<number, (answer: Answer) => void>();

  /** @param find - finds the dev server, before each connection; @throws Error when there is none */
  constructor(private readonly find: () => EditorPlace | Promise<EditorPlace>) {}

  /**
   * Runs a tool in the editor.
   * @throws Error (as a rejection) with the remedy, when the editor cannot be reached or does not answer
   */
  async call(tool: string, input: unknown): Promise<Answer> {
    const socket = await (this.socket ??= this.open());
    const id = ++this.count;
    return new Promise<Answer>((resolve, reject) => {
      const timer = setTimeout(() => {
        this.waiting.delete(id);
        reject(new Error(`${tool} was not answered in ${PATIENCE / 1000} s: see whether the editor's tab is open.`));
      }, PATIENCE);
      this.waiting.set(id, (answer) => {
        clearTimeout(timer);
        resolve(answer);
      });
      this.send(socket, { kind: 'call', id, tool, input });
    });
  }

  close(): void {
    const { socket } = this;
    this.socket = null;
    void socket?.then((open) => open.close()).catch(() => {});
  }

  private async open(): Promise<WebSocket> {
    try {
      const { url, key } = await this.find();
      const address = new URL('/farol-live?agent', url);
      address.protocol = address.protocol.replace('http', 'ws');
      const socket = new WebSocket(address, { headers: { 'x-farol-agent': key }, maxPayload: MOST_BYTES });
      await new Promise<void>((resolve, reject) => {
        socket.once('open', resolve);
        socket.once('error', reject);
      });
      socket.on('error', () => {});
      socket.on('message', (data) => this.take(socket, JSON.parse(String(data)) as ToolResult | { kind: string }));
      socket.on('close', () => this.closed(`The connection to the dev server at ${url} was lost: call again.`));
      this.send(socket, { kind: 'name', name: this.name });
      return socket;
    } catch (error) {
      this.socket = null;
      const reason = error instanceof Error ? error.message : String(error);
      throw new Error(`The editor cannot be reached (${reason}). Ask the user to start it by “npm start”.`, {
        cause: error,
      });
    }
  }

  private take(socket: WebSocket, message: ToolResult | { kind: string }): void {
    if (message.kind === 'there') this.send(socket, { kind: 'name', name: this.name });
    else if (message.kind === 'away') this.answerAll(NOT_ALLOWED);
    else if (message.kind === 'result') {
      const { id, content, isError } = message as ToolResult;
      this.waiting.get(id)?.({ content, isError });
      this.waiting.delete(id);
    }
  }

  private closed(problem: string): void {
    this.socket = null;
    this.answerAll(problem);
  }

  private answerAll(problem: string): void {
    const all = [...this.waiting.values()];
    this.waiting.clear();
    for (const answer of all) answer({ content: [{ type: 'text', text: problem }], isError: true });
  }

  private send(socket: WebSocket, message: AgentMessage): void {
    socket.send(JSON.stringify(message), () => {});
  }
}
