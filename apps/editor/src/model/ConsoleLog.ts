import { Signal } from '@farol/editing';
import { inShownLanguage } from '../language/shownLanguage';
import { readableText } from './readableText';

export type ConsoleKind = 'error' | 'warning' | 'info';

/** Part of the editor that a message is about. */
export type ConsoleSource =
  | 'editor'
  | 'shader'
  | 'file'
  | 'asset'
  | 'component'
  | 'script'
  | 'picture'
  | 'plugin'
  | 'page';

/** A line (from 1) of a microshader or script, given by name. */
export type ConsolePlace =
  | { readonly chunk: string; readonly line: number }
  | { readonly script: string; readonly line: number };

export interface ConsoleEntry {
  readonly id: number;
  readonly kind: ConsoleKind;
  readonly source: ConsoleSource;
  readonly text: string;
  readonly count: number;
  /** Time of the last repetition (ms since 1970). */
  readonly time: number;
  /** The microshader or script that the message is about, and the line (from 1). */
  readonly place?: ConsolePlace;
}

/** Maximum number of messages; the oldest are dropped. */
const LIMIT = 500;

/** Messages logged since the page was opened. A repeated message is one entry with a count. */
export class ConsoleLog {
  readonly changed = new Signal();

  private list: readonly ConsoleEntry[] = [];
  private ids = 0;

  /** Entries, oldest first; a new array after each change. */
  get entries(): readonly ConsoleEntry[] {
    return this.list;
  }

  count(kind: ConsoleKind): number {
    return this.list.reduce((sum, entry) => sum + (entry.kind === kind ? 1 : 0), 0);
  }

  /** Logs a message. A repeated one moves to the end, and its count grows. */
  add(kind: ConsoleKind, source: ConsoleSource, message: string, place?: ConsolePlace): void {
    const text = inShownLanguage(readableText(message));
    const isSame = (entry: ConsoleEntry): boolean =>
      entry.kind === kind && entry.source === source && entry.text === text;
    const before = this.list.find(isSame);
    const entry: ConsoleEntry = {
      id: before?.id ?? ++this.ids,
      kind,
      source,
      text,
      count: (before?.count ?? 0) + 1,
      time: Date.now(),
      ...(place && { place }),
    };
    const others = before ? this.list.filter((each) => each !== before) : this.list.slice(-(LIMIT - 1));
    this.list = [...others, entry];
    this.changed.emit();
  }

  clear(): void {
    this.list = [];
    this.changed.emit();
  }
}
