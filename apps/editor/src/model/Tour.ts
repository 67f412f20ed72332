import { Signal } from '@farol/editing';

/** Current step of the tour of the window. */
export class Tour {
  readonly changed = new Signal();

  private step: number | null = null;

  /** Index of the shown step; null when the tour is not running. */
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
