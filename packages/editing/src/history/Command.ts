/** Selection after a command is done, and after it is undone: ids of GameObjects, or objects of three's. */
export interface CommandSelection<Item = string> {
  readonly done: readonly Item[];
  readonly undone: readonly Item[];
}

/**
 * One edit of a document. `do` and `undo` alternate, beginning with `do`, and each always leads to the same state of
 * the document. A call that throws has changed nothing.
 */
export interface Command<Item = string> {
  /** Label of the step in menus, as in 'Undo move'. */
  readonly label: string;
  /** Whether the command changes nothing; it is then not added to the history. */
  readonly isEmpty?: boolean;
  /** Selection after `do` and after `undo`; unchanged when absent. */
  readonly selection?: CommandSelection<Item>;
  do(): void;
  undo(): void;
  /**
   * Called while this command is done: does `next` in place of it, without an undo in between.
   * @returns the combined command, which also undoes this one; null, with nothing changed, when `next` edits something
   *   else
   */
  replaceWith?(next: Command<Item>): Command<Item> | null;
  /**
   * Called once the command can be neither undone nor redone: disposes of objects that only the command refers to.
   * @param isDone - whether the command is done, not undone
   */
  forget?(isDone: boolean): void;
}
