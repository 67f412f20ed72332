import { Signal } from '@farol/editing';

/** A text, and a line of it (from 1; 0 for none) to go to. */
export interface TextPlace {
  /** Of a microshader or of a script. */
  readonly name: string;
  readonly line: number;
}

/** What a panel of texts shall show. */
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
