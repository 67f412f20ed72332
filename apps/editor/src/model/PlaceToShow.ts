import { Signal } from '@farol/editing';

/** A line (from 1; 0 for none) of a text to scroll to. */
export interface TextPlace {
  /** Name of a microshader or of a script. */
  readonly name: string;
  readonly line: number;
}

/** The place in a text that a panel scrolls to. */
export class PlaceToShow {
  private readonly changed = new Signal();
  private place: TextPlace | null = null;

  get current(): TextPlace | null {
    return this.place;
  }

  readonly subscribe = (listener: () => void): (() => void) => this.changed.subscribe(listener);

  show(place: TextPlace): void {
    this.place = place;
    this.changed.emit();
  }
}
