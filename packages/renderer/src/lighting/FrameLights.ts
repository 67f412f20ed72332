import type { Object3D, WebGLRenderer } from 'three';
import type { Frame } from '../frame/Frame';
import { FrameUniforms } from '../frame/FrameUniforms';
import type { LightFinder } from '../frame/LightFinder';
import type { LightLayers } from '../lazy/shadows/LightLayers';
import type { ShadowedLights } from '../lights/classifyLight';
import { type LightOrder, LightTable } from './LightTable';
import { shadowedLights } from './shadowedLights';

/** Settings of a FarolRenderer that lights depend on. */
export interface LightSettings {
  readonly webgl: WebGLRenderer;
  readonly lightLayers: boolean;
  readonly shadowCascades: number;
  readonly heatMapMaximum: number;
}

/** The lights of a frame: sorted out, masked, written to the table and sent. */
export class FrameLights {
  readonly table = new LightTable();
  readonly uniforms = new FrameUniforms(this.table);
  private readonly masks = { shadows: 'none' as ShadowedLights, layers: null as LightLayers | null };

  /**
   * Brings the lights of a frame up to date.
   * @param finder has found the lights of the scene
   * @param pick picks the technique, by the lights that are seen. @returns the order that it wants them in
   */
  update(scene: Object3D, frame: Frame, finder: LightFinder, settings: LightSettings, pick: () => LightOrder): void {
    const { table, masks } = this;
    const { webgl } = settings;
    const { shadows } = finder;
    const layers = shadows?.layers ?? null;
    masks.shadows = shadowedLights(webgl);
    masks.layers = layers;
    layers?.begin(scene, settings.lightLayers);
    table.collect(finder.found.all, frame.camera, masks);
    layers?.end();
    const order = pick();
    if (shadows !== null) {
      shadows.cascades = Math.min(4, Math.max(1, Math.round(settings.shadowCascades)));
      shadows.update(scene, frame.camera, table.masked, frame);
    }
    frame.shadowMapsDrawn = shadows?.drawn ?? 0;
    frame.queue.layers = layers?.reference ?? 0;
    table.write(frame.camera, order, frame, shadows);
    this.uniforms.set(webgl, frame, shadows, settings.heatMapMaximum);
  }

  dispose(): void {
    this.table.dispose();
    this.masks.layers = null;
    this.uniforms.freeMasks();
  }
}
