import { type Gesture, Signal } from '@farol/editing';
import { type GameObject, Light, ModelRenderer, ObjectRenderer } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { Box3, Ray, Vector3 } from 'three';
import type { ArrangedPlace, Arrangement } from '../../model/arrange/Arrangement';
import { arrangedPlaces } from '../../model/arrange/arrangedPlaces';
import { arrangeObjects } from '../../model/arrange/arrangeObjects';
import { topmost } from '../../model/commands/Placement';
import type { EditorDocument } from '../../model/EditorDocument';
import type { Tool } from '../../model/Tools';
import { boundsOf } from '../boundsOf';
import { scatteredPlaces } from './scatteredPlaces';
import { SurfaceBelow } from './SurfaceBelow';
import { SurfaceSampler } from './SurfaceSampler';
import { surfacesAlong } from './surfaces';
import type { Camera } from 'three';

const draws = (object: GameObject): boolean =>
  (object.getComponent(ObjectRenderer) ?? object.getComponent(ModelRenderer)) !== null;

/** Whether an object or a descendant has a light. */
function holdsLight(object: GameObject): boolean {
  let holds = false;
  object.traverse((each) => (holds ||= each.getComponent(Light) !== null));
  return holds;
}

/** Rounds up to 1, 2 or 5 times a power of ten. */
function niceLength(length: number): number {
  const power = 10 ** Math.floor(Math.log10(length));
  const factor = [1, 1.5, 2, 3, 5].find((each) => each * power >= length * 0.999) ?? 10;
  return Number((factor * power).toPrecision(3));
}

/**
 * Copies the selection along a line, a ring, a grid or over a surface, with a preview while settings change, as one
 * step of history. Any other edit meanwhile commits the previewed copies.
 */
export class DuplicateTool implements Tool {
  readonly id = 'duplicate';
  /** Emits when the settings, the surface or the copies change. */
  readonly changed = new Signal();
  /** Objects to copy. */
  readonly sources: readonly GameObject[];
  readonly hasLights: boolean;

  private readonly gesture: Gesture;
  private current: Arrangement;
  private targetObject: GameObject | null;
  private places: readonly ArrangedPlace[] = [];
  private sampler: SurfaceSampler | null = null;
  private samplerKey = '';
  private readonly endings: (() => void)[];

  /**
   * @param camera - only surfaces on its layers are found
   * @param onEnd - called when another edit or tool has ended this one
   */
  constructor(
    private readonly document: EditorDocument,
    private readonly camera: Camera,
    onEnd: () => void,
  ) {
    const { commands, selection, scene } = document;
    // the gesture begins first: this ends an open gesture of another tool, which may restore values that are read below
    this.gesture = commands.begin();
    const selected = document.selectedObjects;
    const last = selected.at(-1)!;
    const others = selected.slice(0, -1);
    // when a mesh was selected after lights, these are scattered over it
    const overLast = others.length > 0 && draws(last) && !others.some(draws);
    this.sources = topmost(overLast ? others : selected, scene);
    scene.three.updateMatrixWorld();
    this.targetObject = overLast ? last : this.surfaceBelow();
    this.hasLights = this.sources.some(holdsLight);
    this.current = this.firstArrangement();
    this.endings = [
      commands.changed.subscribe(() => !this.gesture.isOpen && onEnd()),
      selection.changed.subscribe(() => this.useSelectionAsTarget()),
    ];
    this.preview();
  }

  get arrangement(): Arrangement {
    return this.current;
  }

  /** Changes settings, and updates the preview. */
  set(settings: Partial<Arrangement>): void {
    this.current = { ...this.current, ...settings };
    this.preview();
  }

  /** Surface that copies are scattered over, taken from the selection; null when there is none yet. */
  get target(): GameObject | null {
    return this.targetObject;
  }

  /** Number of objects, originals included. */
  get total(): number {
    return Math.max(this.sources.length, this.places.length);
  }

  /** Commits the previewed copies as one step of history. */
  apply(): void {
    this.gesture.commit();
  }

  end(): void {
    for (const end of this.endings) end();
    this.gesture.discard();
  }

  private preview(): void {
    const { gesture, document, sources } = this;
    if (!gesture.isOpen) return;
    gesture.reset();
    const { scene } = document;
    scene.three.updateMatrixWorld();
    this.places = this.placesNow();
    if (this.places.length > 0) gesture.preview(arrangeObjects(scene, sources, this.places, this.current));
    this.changed.emit();
  }

  private placesNow(): readonly ArrangedPlace[] {
    const { current, sources, targetObject, document } = this;
    if (current.kind === 'scatter') {
      if (!targetObject?.scene) return [];
      const key = `${targetObject.id} ${current.upwards}`;
      if (!this.sampler || this.samplerKey !== key) this.sampler = new SurfaceSampler([targetObject], current.upwards);
      this.samplerKey = key;
      return scatteredPlaces(current, this.sampler, sources.map(footOf));
    }
    const origins = sources.map(({ transform }) => transform.worldPosition.toArray() as Vector3Tuple);
    const places = arrangedPlaces(current, origins);
    if (!current.follows) return places;
    const below = new SurfaceBelow(document.scene, new Set(sources));
    const feet = sources.map(footOf);
    return places.map((place) => {
      const [x, y, z] = place.position;
      return { ...place, position: [x, below.heightAt({ x, y, z }) + current.height + feet[place.source], z] };
    });
  }

  private firstArrangement(): Arrangement {
    const box = boundsOf(this.sources);
    const size = box.getSize(new Vector3());
    const wide = Math.max(size.x, size.z);
    const step = niceLength(Math.max(1, 1.25 * wide));
    return {
      kind: 'line',
      count: 5,
      offset: [step, 0, 0],
      radius: niceLength(Math.max(3, 1.5 * wide)),
      arc: 2 * Math.PI,
      turns: false,
      counts: [5, 1, 5],
      spacing: [step, niceLength(Math.max(1, 1.25 * size.y)), step],
      minimumDistance: 0,
      upwards: true,
      aligns: false,
      randomTurn: false,
      sizeVariation: 0,
      follows: false,
      height: this.hasLights && wide < 0.5 ? 1 : 0,
      seed: 1,
      colours: 'same',
      sharesLight: false,
      intensityVariation: 0,
      rangeVariation: 0,
      grouped: true,
    };
  }

  /** An object with a mesh on which the originals stand; null when there is none. */
  private surfaceBelow(): GameObject | null {
    const { document, camera, sources } = this;
    const from = boundsOf(sources).getCenter(new Vector3());
    const ray = new Ray(from, new Vector3(0, -1, 0));
    return surfacesAlong(document.scene, ray, camera, new Set(sources))[0]?.object ?? null;
  }

  /** Uses the object that the user selects while the tool is open as the surface. */
  private useSelectionAsTarget(): void {
    const { document, sources, targetObject } = this;
    const object = document.selectedObjects.at(-1);
    if (this.current.kind !== 'scatter' || !object || object === targetObject) return;
    for (let above: GameObject | null = object; above; above = above.parent) if (sources.includes(above)) return;
    const holds = boundsOf([object]);
    if (holds.isEmpty() || holds.getSize(new Vector3()).length() === 0) return;
    this.targetObject = object;
    this.preview();
  }
}

/** Height of an object's origin above its lowest point (m); 0 without a mesh. */
export function footOf(object: GameObject): number {
  let isDrawn = false;
  object.traverse((each) => (isDrawn ||= draws(each)));
  if (!isDrawn) return 0;
  const box = boundsOf([object], new Box3());
  return box.isEmpty() ? 0 : object.transform.worldPosition.y - box.min.y;
}
