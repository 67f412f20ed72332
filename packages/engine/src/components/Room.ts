import { boolean, choice, number } from '@farol/editing/fields';
import type { BufferGeometry } from 'three';
import type { NewObject } from '../core/NewObject';
import { fitOpening, isInOpening, type Opening, type OpeningSize } from '../geometry/openings';
import { solidGrid } from '../geometry/solidGrid';
import { drawnShape, metres, shapeComponent, size } from './shapeComponent';

const sides = ['front', 'right', 'back', 'left'] as const;
type Side = (typeof sides)[number];

const where = {
  options: ['none', ...sides],
  labels: { none: 'None', front: 'Front', right: 'Right', back: 'Back', left: 'Left' },
} as const;
const ofDoor = { group: 'Door', visibleWhen: { field: 'door', equals: sides } };
const ofWindow = { group: 'Window', visibleWhen: { field: 'window', equals: sides } };

/**
 * A room of four walls: its floor at y = 0, its inside `width` along x and `depth` along z, with a door and a window.
 * The front is towards +z. The object's ObjectRenderer draws it.
 */
export class Room extends shapeComponent({
  width: number(4, { ...size, help: 'Width of the inside.' }),
  depth: number(3, { ...size, help: 'Depth of the inside.' }),
  height: number(2.6, { ...size, help: 'Height of the inside.' }),
  thickness: number(0.15, { ...size, step: 0.01, help: 'How thick walls, floor and ceiling are.' }),
  floor: boolean(true, { help: 'Whether there is a floor.' }),
  ceiling: boolean(true, { help: 'Whether there is a ceiling.' }),
  door: choice('front', where.options, {
    help: 'Which wall has the door.',
    label: 'Wall with the door',
    optionLabels: where.labels,
    group: 'Door',
  }),
  doorWidth: number(0.9, { ...size, help: 'Width of the doorway.', label: 'Door width', ...ofDoor }),
  doorHeight: number(2.05, { ...size, help: 'Height of the doorway.', label: 'Door height', ...ofDoor }),
  doorOffset: number(0, {
    ...metres,
    help: 'From the middle of the wall to that of the doorway.',
    label: 'Door offset',
    ...ofDoor,
  }),
  window: choice('none', where.options, {
    help: 'Which wall has the window.',
    label: 'Wall with the window',
    optionLabels: where.labels,
    group: 'Window',
  }),
  windowWidth: number(1.4, { ...size, help: 'Width of the window.', label: 'Window width', ...ofWindow }),
  windowHeight: number(1.2, { ...size, help: 'Height of the window.', label: 'Window height', ...ofWindow }),
  windowSill: number(0.9, {
    ...metres,
    min: 0,
    help: 'From the floor to the bottom of the window.',
    label: 'Sill',
    ...ofWindow,
  }),
  windowOffset: number(0, {
    ...metres,
    help: 'From the middle of the wall to that of the window.',
    label: 'Window offset',
    ...ofWindow,
  }),
}) {
  static override readonly typeName: string = 'Room';
  static override readonly icon: string = 'room';
  static override readonly unique: boolean = true;
  static override readonly help: string = 'A room with a door and a window: the shape that the Object Renderer draws.';
  static override readonly newObjects: readonly NewObject[] = [{ label: 'Room', group: 'building', with: drawnShape }];

  /** Door and window, fitted to the walls that they are in. */
  private openings(): { side: Side; opening: Opening }[] {
    const found: { side: Side; opening: Opening }[] = [];
    const add = (side: Side | 'none', asked: OpeningSize): void => {
      if (side === 'none') return;
      const opening = fitOpening(asked, isAlongX(side) ? this.width : this.depth, this.height);
      if (opening) found.push({ side, opening });
    };
    add(this.door, { width: this.doorWidth, height: this.doorHeight, sill: 0, offset: this.doorOffset });
    const { windowWidth, windowHeight, windowSill, windowOffset } = this;
    add(this.window, { width: windowWidth, height: windowHeight, sill: windowSill, offset: windowOffset });
    return found;
  }

  /** @internal */
  override makeShape(): BufferGeometry {
    const { height, thickness, floor, ceiling } = this;
    const [x, z] = [this.width / 2, this.depth / 2];
    const openings = this.openings();
    const alongX = openings.filter(({ side }) => isAlongX(side)).flatMap(({ opening }) => [opening.from, opening.to]);
    const alongZ = openings.filter(({ side }) => !isAlongX(side)).flatMap(({ opening }) => [opening.from, opening.to]);
    const planes = [
      [-x - thickness, -x, x, x + thickness, ...alongX],
      [-thickness, 0, height, height + thickness, ...openings.flatMap(({ opening }) => [opening.bottom, opening.top])],
      [-z - thickness, -z, z, z + thickness, ...alongZ],
    ] as const;
    return solidGrid(planes, ([px, py, pz]) => {
      if (py < 0) return floor;
      if (py > height) return ceiling;
      if (Math.abs(px) < x && Math.abs(pz) < z) return false;
      // a corner belongs to no wall, but counts as part of one here: openings never reach into it
      const side = Math.abs(px) < x ? (pz > 0 ? 'front' : 'back') : px > 0 ? 'right' : 'left';
      return !openings.some((each) => each.side === side && isInOpening(each.opening, isAlongX(side) ? px : pz, py));
    });
  }
}

const isAlongX = (side: Side): boolean => side === 'front' || side === 'back';
