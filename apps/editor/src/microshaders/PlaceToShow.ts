import { Signal } from '@farol/editing';

/** A microshader, and a line of its text (from 1; 0 for none) to go to. */
export interface MicroShaderPlace {
  readonly chunk: string;
  readonly line: number;
}

/** What the Microshaders panel shall show. */
export class PlaceToShow {
  private readonly changed = new Signal();
  private place: MicroShaderPlace | null = null;

  get current(): MicroShaderPlace | null {
    return this.place;
  }

  readonly subscribe = (listener: () => void): (() => void) => this.changed.subscribe(listener);

  show(place: MicroShaderPlace): void {
    this.place = place;
    this.changed.emit();
  }
}
