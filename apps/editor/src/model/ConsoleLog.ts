import { Signal } from '@farol/editing';
import { inShownLanguage } from '../language/shownLanguage';
import { readableText } from './readableText';

export type ConsoleKind = 'error' | 'warning' | 'info';

/** What a message is about. */
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

/** A line (from 1) of a microshader or of a script, by its name. */
export type ConsolePlace =
  | { readonly chunk: string; readonly line: number }
  | { readonly script: string; readonly line: number };

export interface ConsoleEntry {
  readonly id: number;
  readonly kind: ConsoleKind;
  readonly source: ConsoleSource;
  readonly text: string;
  /** How often the same was said. */
  readonly count: number;
  /** When it was said last (ms since 1970). */
  readonly time: number;
  /** The microshader or the script that it is about, and the line (from 1). */
  readonly place?: ConsolePlace;
}

/** Messages that are kept; the oldest go first. */
const LIMIT = 500;

/** Everything that was said since the page was opened: the same once, with its count. */
export class ConsoleLog {
  readonly changed = new Signal();

  private list: readonly ConsoleEntry[] = [];
  private ids = 0;

  /** Oldest first; another array after each change. */
  get entries(): readonly ConsoleEntry[] {
    return this.list;
  }

  /** How many entries of a kind there are. */
  count(kind: ConsoleKind): number {
    return this.list.reduce((sum, entry) => sum + (entry.kind === kind ? 1 : 0), 0);
  }

  /** Says something. What was said before is said again at the end, and counted. */
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
