import { choice, number } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import type { NewObject } from '../core/NewObject';
import { fitOpening, isInOpening } from '../geometry/openings';
import { solidGrid } from '../geometry/solidGrid';
import { drawnShape, metres, shapeComponent, size } from './shapeComponent';

const hole = { group: 'Opening', visibleWhen: { field: 'opening', equals: ['door', 'window'] } };

/** A straight wall along x, its foot at y = 0, with a door or a window. The object's ObjectRenderer draws it. */
export class Wall extends shapeComponent({
  length: number(4, { ...size, help: 'How long the wall is.' }),
  height: number(2.6, { ...size, help: 'How high the wall is.' }),
  thickness: number(0.15, { ...size, step: 0.01, help: 'How thick the wall is.' }),
  opening: choice('door', ['none', 'door', 'window'], {
    help: 'What goes through the wall.',
    optionLabels: { none: 'None', door: 'Door', window: 'Window' },
    group: 'Opening',
  }),
  openingWidth: number(0.9, { ...size, help: 'Width of the door or window.', label: 'Opening width', ...hole }),
  openingHeight: number(2.05, { ...size, help: 'Height of the door or window.', label: 'Opening height', ...hole }),
  openingOffset: number(0, {
    ...metres,
    help: 'From the middle of the wall to that of the door or window.',
    label: 'Opening offset',
    ...hole,
  }),
  sill: number(0.9, {
    ...metres,
    min: 0,
    help: 'From the floor to the bottom of the window.',
    group: 'Opening',
    visibleWhen: { field: 'opening', equals: ['window'] },
  }),
}) {
  static override readonly typeName: string = 'Wall';
  static override readonly icon: string = 'wall';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A wall with a door or a window: the shape that the Object Renderer draws.';
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Wall', group: 'building', with: drawnShape }];

  /** @internal */
  override makeShape(): BufferGeometry {
    const { length, height, thickness, opening } = this;
    const sill = opening === 'window' ? this.sill : 0;
    const asked = { width: this.openingWidth, height: this.openingHeight, sill, offset: this.openingOffset };
    const fitted = opening === 'none' ? null : fitOpening(asked, length, height);
    const [x, z] = [length / 2, thickness / 2];
    const planes = [
      [-x, x, ...(fitted ? [fitted.from, fitted.to] : [])],
      [0, height, ...(fitted ? [fitted.bottom, fitted.top] : [])],
      [-z, z],
    ] as const;
    return solidGrid(planes, ([along, up]) => fitted === null || !isInOpening(fitted, along, up));
  }
}
