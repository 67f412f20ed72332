import type { WebGLRenderer } from 'three';
import type { Frame } from '../frame/Frame';
import { sharedUniforms } from '../frame/sharedUniforms';
import type { LightTable } from '../lighting/LightTable';
import type { ShadowMaps } from '../shadows/ShadowMaps';

/** Sets the shared uniforms of a renderer for each frame. */
export class FrameUniforms {
  readonly values;

  constructor(private readonly lights: LightTable) {
    this.values = sharedUniforms(lights.ambient);
  }

  /** Uploads the light table, and sets its uniforms. @param heatMaximum - count that count views show hottest */
  set(webgl: WebGLRenderer, frame: Frame, shadows: ShadowMaps | null, heatMaximum: number): void {
    const { lights, values } = this;
    lights.upload(webgl);
    values.farol_lightTable.value = frame.fields?.texture ?? lights.table.texture;
    values.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    const counts = values.farol_lightCounts.value;
    counts[0] = lights.directional;
    counts[1] = lights.unbounded;
    counts[2] = lights.listed;
    counts[3] = lights.others;
    const areas = values.farol_areaCounts.value;
    areas[0] = lights.boundeds.length + lights.slots - lights.others;
    areas[1] = lights.areas;
    shadows?.setUniforms(values, lights.firstMask + lights.slots, frame.camera);
    values.farol_heatScale.value = 1 / heatMaximum;
  }

  /** Clears the uniforms of disposed shadow maps' textures: three would create bound textures again. */
  freeMasks(): void {
    const { values } = this;
    values.farol_images.value = [null];
    values.farol_shadowAtlas.value = values.farol_lightAtlas.value = values.farol_tileShadows.value = null;
  }
}
