import { Signal } from './Signal';

/** One edit: `redo` and `undo` alternate, and each leaves what it left the last time. */
export interface Edit {
  /** What was done, as in 'Undo move'. */
  readonly label: string;
  undo(): void;
  redo(): void;
}

/** What was done, and what was undone and may be done again. */
export class History {
  /** Emits when something was done, undone or done again. */
  readonly changed = new Signal();
  private readonly done: Edit[] = [];
  private readonly undone: Edit[] = [];

  /** @param limit edits that are kept; the oldest go first */
  constructor(private readonly limit = 500) {}

  /** Label of the edit that `undo` takes back; null when there is none. */
  get undoLabel(): string | null {
    return this.done.at(-1)?.label ?? null;
  }

  /** Label of the edit that `redo` does again; null when there is none. */
  get redoLabel(): string | null {
    return this.undone.at(-1)?.label ?? null;
  }

  /** Keeps an edit that is done already. */
  keep(edit: Edit): void {
    this.undone.length = 0;
    this.done.push(edit);
    if (this.done.length > this.limit) this.done.shift();
    this.changed.emit();
  }

  /** Takes the last edit back. @returns whether there was one */
  undo(): boolean {
    const edit = this.done.pop();
    if (!edit) return false;
    edit.undo();
    this.undone.push(edit);
    this.changed.emit();
    return true;
  }

  /** Does the last undone edit again. @returns whether there was one */
  redo(): boolean {
    const edit = this.undone.pop();
    if (!edit) return false;
    edit.redo();
    this.done.push(edit);
    this.changed.emit();
    return true;
  }
}
