/** Selection after a command is done, and after it is undone: ids of GameObjects, or objects of three's. */
export interface CommandSelection<Item = string> {
  readonly done: readonly Item[];
  readonly undone: readonly Item[];
}

/**
 * One edit of a document. `do` and `undo` alternate, beginning with `do`; after either, the document is exactly what it
 * was after the same call before. A call that throws has changed nothing.
 */
export interface Command<Item = string> {
  /** Name of the step in menus, as in 'Undo move'. */
  readonly label: string;
  /** Whether the command changes nothing; such a command is not kept in the history. */
  readonly isEmpty?: boolean;
  /** Selection after `do` and after `undo`; unchanged when absent. */
  readonly selection?: CommandSelection<Item>;
  do(): void;
  undo(): void;
  /**
   * While this command is done: does `next` in its stead, without undoing this one first.
   * @returns the command that leads from before this one to after `next`; null, with nothing changed, where `next` edits
   *   something else
   */
  replaceWith?(next: Command<Item>): Command<Item> | null;
  /**
   * Called when the command can be neither undone nor redone any more: disposes of objects that only the command holds.
   * @param isDone - whether the command is done, not undone
   */
  forget?(isDone: boolean): void;
}
