import { Signal } from '@farol/editing';
import type { ConsoleLog, ConsoleSource } from './ConsoleLog';

export interface Notice {
  readonly id: number;
  readonly kind: 'info' | 'warning' | 'error';
  readonly text: string;
}

/** Short messages that the user should see and need not answer. */
export class Notices {
  readonly changed = new Signal();

  /** @param log - is told everything too */
  constructor(private readonly log?: ConsoleLog) {}

  private list: readonly Notice[] = [];
  private count = 0;

  /** The messages on show, oldest first; another array after each change. */
  get current(): readonly Notice[] {
    return this.list;
  }

  /** Shows a message; the same text is there once only. @returns its id, for `remove` */
  show(kind: Notice['kind'], text: string, source: ConsoleSource = 'editor'): number {
    this.log?.add(kind, source, text);
    this.list = [...this.list.filter((notice) => notice.text !== text).slice(-3), { id: ++this.count, kind, text }];
    this.changed.emit();
    return this.count;
  }

  /** Takes a message away that says what is so no longer. */
  remove(id: number): void {
    if (!this.list.some((notice) => notice.id === id)) return;
    this.list = this.list.filter((notice) => notice.id !== id);
    this.changed.emit();
  }
}
