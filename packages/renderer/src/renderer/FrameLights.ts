import type { Object3D, WebGLRenderer } from 'three';
import type { Frame } from '../frame/Frame';
import { FrameUniforms } from './FrameUniforms';
import type { LightFinder } from './LightFinder';
import { gridCode, tileCode } from '../techniques/techniqueCode';
import { lightFieldCode, warmUpCode } from './lazyCode';
import type { LightFields } from '../light-fields/LightFields';
import type { FoundLights } from '../lights/FoundLights';
import type { LightLayers } from '../shadows/LightLayers';
import type { AreaLightTable } from '../lighting/area-lights/AreaLightTable';
import type { ShadowedLights } from '../lights/classifyLight';
import { type LightOrder, LightTable, type RankLights } from '../lighting/LightTable';
import { shadowedLights } from '../lighting/shadowedLights';

/** Settings of a FarolRenderer that lights depend on. */
export interface LightSettings {
  readonly webgl: WebGLRenderer;
  readonly lightLayers: boolean;
  readonly shadowCascades: number;
  readonly shadowAtlasSize: number | null;
  readonly areaLightThreshold: number;
  readonly heatMapMaximum: number;
}

/** Number of lights that are objects from which on the GPU sorts plain point lights, as those of a LightField. */
const PACKED_FROM = 4096;

function rankOf(order: LightOrder): RankLights | null {
  if (order === 'by-volume') return null;
  return order === 'by-grid' ? gridCode.required.rankByGrid : tileCode.required.rankByDepth;
}

/** The lights of a frame: collected, masked, written to the light table and uploaded. */
export class FrameLights {
  readonly table = new LightTable();
  private fields: LightFields | null = null;
  readonly uniforms = new FrameUniforms(this.table);
  private readonly masks = {
    shadows: 'none' as ShadowedLights,
    layers: null as LightLayers | null,
    areas: null as AreaLightTable | null,
  };

  /** Bytes of the light table, shadow maps and light fields. */
  bytesOf({ fields }: Frame, { shadows }: LightFinder): number {
    return this.table.bytes + (shadows?.bytes ?? 0) + (fields?.bytes ?? 0);
  }

  /**
   * Brings the lights of a frame up to date.
   * @param finder - holds the lights found in the scene
   * @param moves - whether code that ran since they were found may have moved them
   * @param pick - picks the technique by the visible lights; returns the order of lights that it needs
   */
  update(
    scene: Object3D,
    frame: Frame,
    finder: LightFinder,
    settings: LightSettings,
    moves: boolean,
    pick: () => LightOrder,
  ): void {
    const { table, masks } = this;
    const { webgl } = settings;
    const { shadows } = finder;
    const layers = shadows?.layers ?? null;
    masks.shadows = shadowedLights(webgl);
    masks.layers = settings.lightLayers ? layers : null;
    masks.areas = finder.areas;
    if (finder.areas !== null) finder.areas.threshold = settings.areaLightThreshold;
    layers?.begin(scene, settings.lightLayers);
    const { all: found, points } = finder.found;
    const { session } = frame;
    const all = session?.lightsOf?.(found) ?? found;
    const known = moves || all !== found ? null : points;
    // the first eye draws the shadow maps of all eyes
    const masked = session?.eye === 0 && shadows !== null ? session.masked(table, all, masks, known) : table.masked;
    const packs = masked === table.masked && known !== null && masks.layers === null && this.pack(finder.found, frame);
    if (masked === table.masked && !packs) table.collect(all, frame.camera, masks, known);
    table.tileLists = null;
    layers?.end();
    let fields = this.beginFields(frame);
    const picked = pick();
    if (packs && picked !== 'by-depth') {
      // the technique has changed to one that would need other programs for fields
      table.collect(all, frame.camera, masks, known);
      fields = this.beginFields(frame);
    }
    // nothing reads the farthest depth when all shaders read the few lights from uniforms
    if (frame.readsFew) frame.queue.farthest = Infinity;
    // clusters of light fields are made on the GPU, from lights sorted by depth
    const order = fields !== null && picked === 'by-grid' ? 'by-depth' : picked;
    if (session !== null && session.eye > 0) shadows?.keep();
    else if (shadows !== null) {
      shadows.areas = finder.areas;
      shadows.cascades = Math.min(4, Math.max(1, Math.round(settings.shadowCascades)));
      shadows.atlasSize = settings.shadowAtlasSize;
      shadows.isLite = frame.isLite;
      shadows.seenBy = frame.seenBy;
      shadows.update(scene, frame.camera, masked, frame);
    }
    frame.tileShadows = shadows;
    frame.shadowMapsDrawn = shadows?.drawn ?? 0;
    frame.queue.shadowMasks = shadows?.maskMaterials ?? null;
    frame.queue.layers = layers?.reference ?? 0;
    table.write(frame.camera, order, frame, shadows, rankOf(order));
    session?.written?.(frame);
    this.uniforms.set(webgl, frame, shadows, settings.heatMapMaximum);
  }

  /** Collects many lights by packing them, as soon as the code and programs for it are there. @returns whether it did */
  private pack(found: FoundLights, frame: Frame): boolean {
    if (this.table.tileLists === null || found.all.length < PACKED_FROM) return false;
    if (!lightFieldCode.ask(false) || !warmUpCode.ask(false)) return false;
    return this.makeFields(frame)?.pack(found, this.masks, warmUpCode.required) === true;
  }

  private beginFields(frame: Frame): LightFields | null {
    const { table } = this;
    const fields = table.fields.length > 0 ? this.makeFields(frame) : null;
    frame.fields = fields;
    table.slots = 0;
    fields?.begin();
    return fields;
  }

  /** Creates the draws of light fields, once; null until their code is loaded. */
  private makeFields(frame: Frame): LightFields | null {
    return (this.fields ??= lightFieldCode.use((code) => code.makeLightFields(frame)));
  }

  /** Frees the lights' textures. @param frame - frame whose references to them are cleared */
  dispose(frame: Frame): void {
    this.fields?.dispose();
    this.fields = frame.fields = null;
    frame.tileShadows = frame.queue.shadowMasks = null;
    this.table.dispose();
    this.masks.layers = this.masks.areas = null;
    this.uniforms.freeMasks();
  }
}
