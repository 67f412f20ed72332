/** Ids of the GameObjects that shall be selected once a command is done, or undone. */
export interface CommandSelection {
  readonly done: readonly string[];
  readonly undone: readonly string[];
}

/**
 * One edit of the document. `do` and `undo` alternate, beginning with `do`; after either, the document is exactly what it
 * was after the same call before. A call that throws has changed nothing.
 */
export interface Command {
  /** What the menus call it, as in 'Undo move'. */
  readonly label: string;
  /** True when nothing differs before and after; such a command is not kept. */
  readonly isEmpty?: boolean;
  /** What to select; the selection stays as it is when absent. */
  readonly selection?: CommandSelection;
  do(): void;
  undo(): void;
  /**
   * While this command is done: does `next` in its stead, without undoing this one first, and gives the command that
   * leads from before this one to after `next`. Null, and nothing is changed, when it does not know how.
   */
  replaceWith?(next: Command): Command | null;
  /** It can be neither undone nor redone any more: gives back what it holds. @param isDone - whether it is done */
  forget?(isDone: boolean): void;
}
