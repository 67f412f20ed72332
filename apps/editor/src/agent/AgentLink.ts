import { Signal, t } from '@farol/editing';
import type { AgentMessage, ToolResult } from '@farol/mcp/tools';
import type { EditorApi } from '../api/EditorApi';
import { liveSocket } from '../files/live/liveParts';
import { readableText } from '../model/readableText';
import { runTool } from './runTool';

/** Maximum number of calls that wait for their turn; more are refused. */
const MOST_WAITING = 32;

/** Maximum length of a client's name as shown (characters). */
const NAME = 40;

type RelayMessage =
  | { readonly kind: 'hello' }
  | { readonly kind: 'left'; readonly number: number }
  | { readonly kind: 'problem'; readonly problem: string }
  | (AgentMessage & { readonly number: number });

/** Connection through the dev server by which AI agents run tools in an editor, from the user's consent until `end`. */
export class AgentLink {
  /** Emits when a client connects, disconnects or calls, and when the link opens or ends. */
  readonly changed = new Signal();
  /** Fulfilled with whether the server accepts agents. */
  readonly opened: Promise<boolean>;
  private readonly names = new Map<number, string>();
  private readonly socket: WebSocket;
  private calls = 0;
  private waiting = 0;
  private isOpen = false;
  private isEnded = false;
  private last: Promise<unknown> = Promise.resolve();

  constructor(private readonly editor: EditorApi) {
    this.socket = liveSocket('allow');
    this.opened = new Promise((resolve) => {
      this.socket.addEventListener('open', () => resolve((this.isOpen = true)));
      this.socket.addEventListener('close', ({ code }) => {
        resolve(false);
        this.lost(code);
      });
    });
    this.socket.addEventListener('message', ({ data }) => this.take(JSON.parse(String(data)) as RelayMessage));
  }

  /** Names of the clients that are connected. */
  get clients(): readonly string[] {
    return [...this.names.values()];
  }

  /** Number of calls by agents since the link began. */
  get count(): number {
    return this.calls;
  }

  get hasEnded(): boolean {
    return this.isEnded;
  }

  /** Closes the connection; waiting calls are not run. */
  end(): void {
    if (this.isEnded) return;
    this.isEnded = true;
    this.socket.close();
    this.changed.emit();
  }

  private lost(code: number): void {
    if (this.isEnded || !this.isOpen) return;
    const text =
      code === 4000
        ? t('Another tab lets an agent edit now, so this one does not any more.')
        : t('The connection to the server was lost, so no agent can edit any more.');
    this.editor.notices.show('warning', text);
    this.end();
  }

  private take(message: RelayMessage): void {
    if (message.kind === 'problem') this.editor.log.add('warning', 'editor', message.problem);
    else if (message.kind === 'left') this.names.delete(message.number);
    else if (message.kind === 'name') this.names.set(message.number, readableText(String(message.name)).slice(0, NAME));
    else if (message.kind === 'call') this.queue(message);
    this.changed.emit();
  }

  private queue({ number, id, tool, input }: Extract<RelayMessage, { kind: 'call' }>): void {
    this.calls++;
    const answer = (result: Pick<ToolResult, 'content' | 'isError'>): void => {
      if (!this.isEnded)
        this.socket.send(JSON.stringify({ kind: 'result', to: number, id, ...result } satisfies ToolResult));
    };
    const refuse = (text: string): void => answer({ content: [{ type: 'text', text }], isError: true });
    if (this.waiting >= MOST_WAITING)
      return refuse(`${MOST_WAITING} calls are waiting already: call again when they are answered.`);
    this.waiting++;
    // calls run one after the other, each on the scene that the call before left
    this.last = this.last.then(async () => {
      this.waiting--;
      if (this.isEnded) return;
      try {
        const client = this.names.get(number) ?? t('An agent');
        answer({ content: await runTool(this.editor, String(tool), input, client) });
      } catch (error) {
        refuse(error instanceof Error ? error.message : String(error));
      }
    });
  }
}

/** Links by editor. */
const links = new WeakMap<EditorApi, AgentLink>();

/** Emits when an editor's link begins or ends. */
export const linksChanged = new Signal();

/** The editor's link to agents; null unless the user allows them. */
export const linkOf = (editor: EditorApi): AgentLink | null => links.get(editor) ?? null;

/** Lets agents edit. @returns false when the server does not accept agents, as in production builds */
export async function allowAgents(editor: EditorApi): Promise<boolean> {
  if (links.has(editor)) return true;
  const link = new AgentLink(editor);
  if (!(await link.opened)) return false;
  links.set(editor, link);
  const end = link.changed.subscribe(() => {
    if (!link.hasEnded) return;
    end();
    links.delete(editor);
    linksChanged.emit();
  });
  linksChanged.emit();
  return true;
}
