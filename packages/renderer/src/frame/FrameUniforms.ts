import { Vector4, type WebGLRenderer } from 'three';
import type { Frame } from './Frame';
import type { LightTable } from '../lighting/LightTable';
import { lightUniforms } from '../lighting/lightUniforms';
import { gridUniforms } from '../lighting/lists/gridUniforms';
import { tileUniforms } from '../lighting/lists/tileUniforms';
import { maskUniforms } from '../lighting/maskUniforms';
import type { ShadowMaps } from '../lazy/shadows/ShadowMaps';

/** The uniforms of all that is drawn in a frame. */
export class FrameUniforms {
  readonly values;

  constructor(private readonly lights: LightTable) {
    this.values = {
      farol_heatScale: { value: 1 / 32 },
      farol_background: { value: new Vector4(0, 0, 0, -1) },
      ...lightUniforms(lights.ambient),
      ...maskUniforms(),
      ...tileUniforms(),
      ...gridUniforms(),
    };
  }

  /** Sends the light table, and sets what tells of it. @param heatMaximum hottest count of the count views */
  set(webgl: WebGLRenderer, frame: Frame, shadows: ShadowMaps | null, heatMaximum: number): void {
    const { lights, values } = this;
    lights.upload(webgl);
    values.farol_lightTable.value = lights.table.texture;
    values.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    const counts = values.farol_lightCounts.value;
    counts[0] = lights.directional;
    counts[1] = lights.unbounded;
    counts[2] = lights.bounded;
    counts[3] = lights.others;
    shadows?.setUniforms(values, lights.firstMask, frame.camera);
    values.farol_heatScale.value = 1 / heatMaximum;
  }

  /** Lets go of the textures of shadow maps, which are disposed: three would make anew what is still bound. */
  freeMasks(): void {
    const { values } = this;
    values.farol_shadowAtlas.value = values.farol_lightAtlas.value = values.farol_tileShadows.value = null;
  }
}
