import { Signal } from '@farol/editing';
import { inShownLanguage } from '../language/shownLanguage';
import type { ConsoleLog, ConsoleSource } from './ConsoleLog';
import { readableText } from './readableText';

export interface Notice {
  readonly id: number;
  readonly kind: 'info' | 'warning' | 'error';
  readonly text: string;
  /** Times that this message was repeated while it was shown. */
  readonly count: number;
  /** Whether the message stays until removed, because it describes a lasting state. */
  readonly lasts: boolean;
}

/** Maximum number of messages shown at a time, besides lasting ones. */
const MOST = 3;

/** Short messages that need no answer. They disappear after a while, but remain in the console. */
export class Notices {
  readonly changed = new Signal();

  /** @param log - every message is logged there too */
  constructor(private readonly log?: ConsoleLog) {}

  private list: readonly Notice[] = [];
  private ids = 0;

  /** The messages that are shown, oldest first; a new array after each change. */
  get current(): readonly Notice[] {
    return this.list;
  }

  /** Shows a message; a repeated text is shown once, with a count. @returns its id, for `remove` */
  show(
    kind: Notice['kind'],
    message: string,
    source: ConsoleSource = 'editor',
    { lasts = false }: { readonly lasts?: boolean } = {},
  ): number {
    const text = inShownLanguage(readableText(message));
    this.log?.add(kind, source, text);
    const before = this.list.find((notice) => notice.text === text);
    const notice: Notice = {
      ...{ kind, text, lasts },
      id: before?.id ?? ++this.ids,
      count: (before?.count ?? 0) + 1,
    };
    const others = this.list.filter((each) => each !== before);
    const passing = others.filter((each) => !each.lasts).slice(1 - MOST);
    this.list = [...others.filter((each) => each.lasts || passing.includes(each)), notice];
    this.changed.emit();
    return notice.id;
  }

  /** Removes a message that was read or is no longer true. */
  remove(id: number): void {
    if (!this.list.some((notice) => notice.id === id)) return;
    this.list = this.list.filter((notice) => notice.id !== id);
    this.changed.emit();
  }
}
