import { type ArrayCamera, type Camera, Color, type Light, type Object3D, Vector2, Vector3 } from 'three';
import { lacksFloatTargets } from '../gpu/checkDevice';
import { hasShadowMap } from '../lights/classifyLight';
import { shadowedLights } from '../lighting/shadowedLights';
import type { FarolRenderer } from '../renderer/FarolRenderer';
import type { TechniqueName } from '../techniques';
import { brightestParts, brightnessOf } from './brightestParts';
import { drawnPrograms } from './drawnPrograms';
import { isAmbient, type LightPart, LightParts, placeOf } from './LightParts';
import { findTerms, type LightTerm } from './LightTerms';
import type { LightShare, OtherShare, PixelLighting, PixelLightingOptions, PixelProgram } from './PixelLighting';
import { PixelPicture } from './PixelPicture';
import { surfacesAt } from './surfacesAt';

/** Time of draws before control returns to the page (ms). */
const SLICE = 40;
/** Difference of a pixel's colours that counts as a change, as a share of its brightness: above rounding of half floats. */
const CHANGE = 1 / 256;

type Measure = Omit<LightShare, 'share'> | Omit<OtherShare, 'share'>;

/**
 * Splits the light of one pixel by its sources: draws the pixel by the current technique with one light after another,
 * and subtracts its colour without lights. Shadows, images and profiles of lights, materials and transparent layers
 * therefore count as in the picture. Draws a small window of the picture for each light, or whole pictures if the pixel
 * depends on others (transmission, ambient occlusion, points); many lights are drawn in groups. The page runs in between;
 * do not change the scene until the promise is fulfilled. Nothing is drawn to the host's target, and the host's objects
 * are restored whenever its code runs.
 *
 * @example
 * const { lights } = await explainPixel(farol, scene, camera, { x: 0, y: 0 });
 * for (const { light, share, distance } of lights) console.log(light.name, share, distance);
 * @param pointer - place in the picture, as `Raycaster.setFromCamera` takes it: -1 to 1 from left to right, from below to above
 * @throws Error in XR sessions, for an ArrayCamera, on a device without float targets, before a first frame was drawn by 'auto', and
 *   when the context is lost; RangeError for a pointer outside of the picture
 */
export async function explainPixel(
  farol: FarolRenderer,
  scene: Object3D,
  camera: Camera,
  pointer: { readonly x: number; readonly y: number },
  options: PixelLightingOptions = {},
): Promise<PixelLighting> {
  const work = new PixelWork(farol, scene, camera, pointer, options);
  try {
    return await work.run();
  } finally {
    work.picture.dispose();
  }
}

/** Technique in use. @throws Error that says why a pixel cannot be explained now */
function check(farol: FarolRenderer, camera: Camera): TechniqueName {
  const { webgl, technique, info } = farol;
  const lacks = lacksFloatTargets(webgl);
  if (lacks !== null)
    throw new Error(`explainPixel: this device ${lacks}, so light cannot be measured; use another device.`);
  if (webgl.xr.isPresenting) throw new Error('explainPixel: an XR session is presenting; end it first.');
  if ((camera as ArrayCamera).isArrayCamera === true)
    throw new Error('explainPixel: an ArrayCamera has several pictures; give one of its cameras and its size.');
  const drawn = (technique === 'auto' ? info.technique : technique) as TechniqueName | '';
  if (drawn === '') throw new Error("explainPixel: 'auto' has picked no technique yet; draw a frame first.");
  return drawn;
}

class PixelWork {
  readonly picture: PixelPicture;
  private readonly technique: TechniqueName;
  private readonly maxLights: number;
  private readonly size;
  private terms: LightTerm[] = [];
  private programs: PixelProgram[] = [];
  private readonly first = new Color();
  private readonly dark = new Color();
  private changed = false;

  constructor(
    private readonly farol: FarolRenderer,
    private readonly scene: Object3D,
    private readonly camera: Camera,
    private readonly pointer: { readonly x: number; readonly y: number },
    private readonly options: PixelLightingOptions,
  ) {
    const { x, y } = pointer;
    if (!(Math.abs(x) <= 1 && Math.abs(y) <= 1))
      throw new RangeError(`explainPixel: the pointer is (${x}, ${y}); give numbers from -1 to 1.`);
    this.maxLights = options.maxLights ?? 128;
    if (!(this.maxLights >= 1))
      throw new RangeError(`explainPixel: maxLights is ${this.maxLights}; give a number of at least 1.`);
    this.technique = check(farol, camera);
    const { width, height } = options.size ?? farol.webgl.getDrawingBufferSize(new Vector2());
    this.size = { width, height };
    const at = (part: number, count: number): number => Math.min(count - 1, Math.floor(((part + 1) / 2) * count));
    const { technique } = this;
    this.picture = new PixelPicture(farol, scene, camera, technique, at(x, width), at(y, height), this.size);
  }

  async run(): Promise<PixelLighting> {
    const { picture, options, scene, camera, pointer } = this;
    await this.fetch();
    this.refresh();
    this.first.copy(picture.readWhole());
    const surfaces = surfacesAt(scene, camera, pointer.x, pointer.y);
    const point = surfaces.at(-1)?.point ?? null;
    const measures = await this.inSlices(this.measure(point));
    this.throwIfOver();
    options.onProgress?.(1);
    const sum = new Color(0);
    for (const { color } of measures) sum.add(color);
    const whole = luminanceOf(sum);
    const shared = measures
      .map((each) => ({ ...each, share: whole > 0 ? luminanceOf(each.color) / whole : 0 }))
      .toSorted((a, b) => brightnessOf(b.color) - brightnessOf(a.color));
    return {
      technique: this.technique,
      x: picture.column,
      y: this.size.height - 1 - picture.row,
      color: this.first,
      sum,
      lights: shared.filter((each): each is LightShare => 'unshadowed' in each),
      others: shared.filter((each): each is OtherShare => 'kind' in each && brightnessOf(each.color) > 0),
      surfaces,
      programs: this.programs,
      effectsLeftOut: picture.parts.leftOut,
      changed: this.changed,
    };
  }

  /** Draws the picture until all code that it needs is loaded. */
  private async fetch(): Promise<void> {
    const { lacking } = this.farol['last'];
    do {
      this.throwIfOver();
      this.picture.drawWhole();
      await Promise.all([...lacking].map((part) => part.load()));
    } while (lacking.size > 0);
    this.throwIfOver();
  }

  private get isLost(): boolean {
    return this.farol.webgl.getContext().isContextLost();
  }

  private throwIfOver(): void {
    this.options.signal?.throwIfAborted();
    if (this.isLost) throw new Error('explainPixel: the WebGL context is lost; call it again once it is restored.');
  }

  /** Draws the whole picture, then finds anew the other sources of light, which are to be turned off. */
  private refresh(): void {
    const { picture, scene, camera } = this;
    picture.drawWhole();
    picture.chooseWindow();
    this.terms = findTerms(scene, picture.items, new Set(picture.parts.found), camera.layers);
  }

  /** Runs draws in slices of time, between which the host runs, with all light except managed lights turned off. */
  private async inSlices(draws: Generator<number, Measure[]>): Promise<Measure[]> {
    let started = performance.now();
    let slice = SLICE;
    this.turnOff();
    try {
      for (;;) {
        const step = draws.next();
        if (step.done === true) return step.value;
        const now = performance.now();
        if (now - started < slice) continue;
        this.turnOn();
        this.options.onProgress?.(step.value);
        await new Promise((resolve) => setTimeout(resolve));
        this.throwIfOver();
        started = performance.now();
        this.refresh();
        // each slice draws the whole picture again, which should take the smaller part of its time
        slice = Math.max(SLICE, 3 * (performance.now() - started));
        this.noteChange();
        this.turnOff();
      }
    } finally {
      this.turnOn();
    }
  }

  private noteChange(): void {
    const now = this.picture.readWhole();
    const { r, g, b } = this.first;
    const difference = Math.max(Math.abs(now.r - r), Math.abs(now.g - g), Math.abs(now.b - b));
    this.changed ||= difference > CHANGE * Math.max(1, r, g, b);
  }

  private turnOff(): void {
    for (const term of this.terms) term.turnOff();
  }

  private turnOn(): void {
    for (const term of this.terms) term.turnOn();
  }

  /** Light that the pixel gets from the given lights alone. */
  private lightOf(lights: readonly Light[], isUnshadowed: boolean): Color {
    return less(this.picture.draw(lights, isUnshadowed), this.dark);
  }

  /** Light that a negative light takes from the light of the others. */
  private takenBy(light: Light): Pick<LightShare, 'color' | 'unshadowed'> {
    const { picture } = this;
    const others = picture.parts.found.filter((each) => each !== light);
    const taken = (isUnshadowed: boolean): Color =>
      less(picture.draw(null, isUnshadowed), picture.draw(others, isUnshadowed));
    return { color: taken(false), unshadowed: taken(true) };
  }

  private *measure(point: Vector3 | null): Generator<number, Measure[]> {
    const { picture, dark } = this;
    const measures: Measure[] = [];
    picture.draw([], false, dark);
    const other = (kind: OtherShare['kind'], color: Color, light: Light | null = null, count = 1): void =>
      void measures.push({ kind, light, count, color });
    other('unlit', dark.clone());
    yield 0;
    this.programs = drawnPrograms(picture.parts.frame!, () => picture.draw(null));
    yield 0;
    // by index, since `refresh` replaces the terms in each slice
    for (let i = 0; i < this.terms.length; i++) {
      const { kind, light } = this.terms[i];
      this.terms[i].turnOn();
      const color = this.lightOf([], false);
      if (kind !== 'light') other(kind, color, light);
      else {
        this.terms[i].unshadow?.();
        const unshadowed = this.terms[i].unshadow ? this.lightOf([], false) : color.clone();
        measures.push({
          light: light!,
          index: null,
          color,
          unshadowed,
          distance: distanceOf({ light: light!, index: null }, point),
        });
        this.terms[i].turnOn();
      }
      this.terms[i].turnOff();
      yield 0;
    }
    for (const light of picture.parts.found) {
      if (!isAmbient(light)) continue;
      other(light.type === 'HemisphereLight' ? 'hemisphere' : 'ambient', this.lightOf([light], false), light);
      yield 0;
    }
    yield* this.measureLights(measures, point);
    return measures;
  }

  private *measureLights(measures: Measure[], point: Vector3 | null): Generator<number, void> {
    const { picture, farol, maxLights } = this;
    const local = picture.parts.found.filter((light) => !isAmbient(light));
    const lights = new LightParts(local, picture.camera);
    const measure = (parts: readonly LightPart[]): Color => this.lightOf(lights.lightsOf(parts), true);
    for (const part of lights.negative) {
      measures.push({ ...part, ...this.takenBy(part.light), distance: distanceOf(part, point) });
      yield 0;
    }
    const { single, rest } = yield* brightestParts(lights.all, measure, maxLights);
    const shadowed = shadowedLights(farol.webgl);
    for (const {
      parts: [part],
      color: unshadowed,
    } of single) {
      const casts = part.index === null && hasShadowMap(part.light, shadowed);
      const color = casts ? this.lightOf([part.light], false) : unshadowed.clone();
      measures.push({ ...part, color, unshadowed, distance: distanceOf(part, point) });
      if (casts) yield 1;
    }
    if (rest.length === 0) return;
    const color = this.lightOf(lights.lightsOf(rest), false);
    measures.push({ kind: 'lights', light: null, count: rest.length, color });
    yield 1;
  }
}

/** Subtracts in place; unlike `Color.sub`, keeps values below 0. */
function less(color: Color, { r, g, b }: Color): Color {
  color.r -= r;
  color.g -= g;
  color.b -= b;
  return color;
}

/** Relative luminance of linear RGB. */
const luminanceOf = ({ r, g, b }: Color): number => 0.2126 * r + 0.7152 * g + 0.0722 * b;

const place = new Vector3();

function distanceOf(part: LightPart, point: Vector3 | null): number | null {
  return (point && placeOf(part, place)?.distanceTo(point)) ?? null;
}
