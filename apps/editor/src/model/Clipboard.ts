import { Signal } from '@farol/editing';

/** Where other tabs of the editor find what was copied. */
const KEY = 'farol-clipboard';

/** Copied objects and values as text: of this tab, and of others of the same browser. It asks for no permission. */
export class Clipboard {
  /** Emits when something was copied here. */
  readonly changed = new Signal();

  private own: string | null = null;

  /** What was copied last; null when nothing was. */
  get text(): string | null {
    try {
      return localStorage.getItem(KEY) ?? this.own;
    } catch {
      return this.own;
    }
  }

  set text(text: string | null) {
    this.own = text;
    try {
      if (text === null) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, text);
    } catch {
      // no storage, or not enough: what was there before must not come back in its place
      try {
        localStorage.removeItem(KEY);
      } catch {
        // no storage at all
      }
    }
    this.changed.emit();
  }
}
