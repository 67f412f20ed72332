import { Signal } from '@farol/editing';

/** Where the tour of the window is. */
export class Tour {
  readonly changed = new Signal();

  private step: number | null = null;

  /** Index of the step that is shown; null when none is. */
  get current(): number | null {
    return this.step;
  }

  start(): void {
    this.show(0);
  }

  /** @param step - index; null ends the tour */
  show(step: number | null): void {
    this.step = step;
    this.changed.emit();
  }
}
