import type { Command } from '@farol/editing';

/** A command that changes components when a plugin is added or removed. */
export class PluginStep implements Command {
  readonly label: string;

  /**
   * @param step - the edit of components
   * @param plugin - `do` is called before `step.do`, so that redo adds or removes the plugin again; `undo` before
   *   `step.undo`
   */
  constructor(
    private readonly step: Command,
    private readonly plugin: { do(): void; undo?(): void },
  ) {
    this.label = step.label;
  }

  do(): void {
    this.plugin.do();
    this.step.do();
  }

  undo(): void {
    this.plugin.undo?.();
    this.step.undo();
  }

  forget(isDone: boolean): void {
    this.step.forget?.(isDone);
  }
}
