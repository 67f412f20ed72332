import type { Camera, Light } from 'three';
import { activeEffects, type ActiveEffects } from '../frame/ActiveEffects';
import type { FarolEffect } from '../frame/FarolEffect';
import type { Frame } from '../frame/Frame';
import type { Session } from '../frame/Session';
import { gbufferLayout } from '../gbuffer/gbufferLayout';
import { drawBuffersOf } from '../gpu/checkDevice';
import type { LightTable } from '../lighting/LightTable';
import type { RecordSettings } from '../lighting/LightRecords';
import { FLOATS_PER_RECORD } from '../lights/lightRecord';
import type { PlainPoints } from '../lights/plainPoints';
import { MASK, RECORDS_PER_MASK } from '../shadows/masks/maskLayout';
import type { ShadowMaps } from '../shadows/ShadowMaps';

/** Whether an effect's picture depends on earlier frames, or on neighbouring pixels. */
const isOfPicture = ({ name, movesCamera, smoothsEdges, takesPicture, replaces }: FarolEffect): boolean =>
  movesCamera === true ||
  smoothsEdges === true ||
  (takesPicture === true && replaces === undefined) ||
  name === 'volumetric fog';

/**
 * Session in which parts of a picture are drawn: first the whole picture, as eye 0, which finds lights and updates shadow maps;
 * then any of its lights, with these maps.
 */
export class DrawnParts implements Session {
  eye = 0;
  readonly effects: ActiveEffects;
  /** Names of the host's effects that are left out. */
  readonly leftOut: readonly string[];
  /** Managed lights of the scene, found by the draw of the whole picture. */
  found: readonly Light[] = [];
  /** Lights of the next draw; null for all. */
  lights: readonly Light[] | null = null;
  /** Whether the next draw leaves out shadows, though not images and profiles of lights. */
  isUnshadowed = false;
  /** Frame of the renderer; null before the first draw. */
  frame: Frame | null = null;

  /** @param camera - the host's camera @param effects - the host's effects */
  constructor(
    gl: WebGL2RenderingContext,
    private readonly camera: Camera,
    effects: readonly FarolEffect[],
  ) {
    const kept = effects.filter((effect) => !isOfPicture(effect));
    this.effects = activeEffects(kept, drawBuffersOf(gl) - gbufferLayout.length);
    this.leftOut = effects.filter(isOfPicture).map(({ name }) => name);
  }

  /** Whether an effect reads neighbours of the pixel that it draws. */
  get readsAround(): boolean {
    return this.effects.all.some(({ name }) => name === 'ambient occlusion');
  }

  lightsOf(found: readonly Light[]): readonly Light[] {
    if (this.eye === 0) {
      this.found = found.slice();
      return found;
    }
    return this.lights ?? this.found;
  }

  written(frame: Frame): void {
    this.frame = frame;
    if (!this.isUnshadowed) return;
    const { table, firstMask } = frame.lights;
    const { data } = table;
    const records = (frame.tileShadows as ShadowMaps | null)?.records ?? 0;
    for (let record = 0; record < records; record += RECORDS_PER_MASK) {
      const at = (firstMask + record) * FLOATS_PER_RECORD + MASK.filtering;
      table.set4(at, data[at], data[at + 1], data[at + 2], 0);
    }
  }

  masked(
    table: LightTable,
    lights: readonly Light[],
    settings: RecordSettings,
    points: PlainPoints | null,
  ): readonly Light[] {
    table.collect(lights, this.camera, settings, points);
    return table.masked;
  }

  refuses(): boolean {
    return false;
  }

  present(): void {}

  dispose(): void {}
}
