import type { Command } from '@farol/editing';

/** An edit of components that goes with a plugin which comes or goes. */
export class PluginStep implements Command {
  readonly label: string;

  /**
   * @param step - the edit
   * @param plugin - `do`: called before the edit is done, so that redo has the plugin as it was; `undo`: before it is undone
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
