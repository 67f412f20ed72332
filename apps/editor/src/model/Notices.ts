import { Signal } from '@farol/editing';
import { inShownLanguage } from '../language/shownLanguage';
import type { ConsoleLog, ConsoleSource } from './ConsoleLog';
import { readableText } from './readableText';

export interface Notice {
  readonly id: number;
  readonly kind: 'info' | 'warning' | 'error';
  readonly text: string;
  /** How often the same was said while it was on show. */
  readonly count: number;
  /** Whether it stays until it is removed, since what it says is so until then. */
  readonly lasts: boolean;
}

/** Messages on show at a time, beside those that last. */
const MOST = 3;

/** Short messages that the user should see and need not answer. They leave by themselves, and stay in the console. */
export class Notices {
  readonly changed = new Signal();

  /** @param log - is told everything too */
  constructor(private readonly log?: ConsoleLog) {}

  private list: readonly Notice[] = [];
  private ids = 0;

  /** The messages on show, oldest first; another array after each change. */
  get current(): readonly Notice[] {
    return this.list;
  }

  /** Shows a message; the same text is there once, with its count. @returns its id, for `remove` */
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

  /** Takes a message away: it was read, or what it says is so no longer. */
  remove(id: number): void {
    if (!this.list.some((notice) => notice.id === id)) return;
    this.list = this.list.filter((notice) => notice.id !== id);
    this.changed.emit();
  }
}
