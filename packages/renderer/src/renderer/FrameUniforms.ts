import type { WebGLRenderer } from 'three';
import type { Frame } from '../frame/Frame';
import { sharedUniforms } from '../frame/sharedUniforms';
import type { LightTable } from '../lighting/LightTable';
import { FLOATS_PER_RECORD, LIGHT } from '../lights/lightRecord';
import type { ShadowMaps } from '../shadows/ShadowMaps';

/** Maximum number of lights in the uniforms of fewLights.glsl. */
const FEW = 2;

/** Sets the shared uniforms of a renderer for each frame. */
export class FrameUniforms {
  readonly values;

  constructor(private readonly lights: LightTable) {
    this.values = sharedUniforms(lights.ambient);
  }

  /** Uploads the light table, and sets its uniforms. @param heatMaximum - count that heat-map views show in their hottest colour */
  set(webgl: WebGLRenderer, frame: Frame, shadows: ShadowMaps | null, heatMaximum: number): void {
    const { lights, values } = this;
    this.giveTable(webgl, frame, shadows);
    values.farol_offset.value.set(frame.viewport.x, frame.viewport.y);
    values.farol_frameSize.value.set(frame.width, frame.height);
    const counts = values.farol_lightCounts.value;
    counts[0] = lights.directional;
    counts[1] = lights.unbounded;
    counts[2] = lights.listed;
    counts[3] = lights.extendedCount;
    const areas = values.farol_areaCounts.value;
    areas[0] = lights.boundeds.length + lights.slots - lights.extendedCount;
    areas[1] = lights.areas;
    shadows?.setUniforms(values, lights.firstMask + lights.slots, frame.camera);
    values.farol_heatScale.value = 1 / heatMaximum;
  }

  /** Binds the light table: as uniforms if lights are few and all shaders of the frame read the uniforms, else as a texture. */
  private giveTable(webgl: WebGLRenderer, frame: Frame, shadows: ShadowMaps | null): void {
    const { lights, values } = this;
    const few = frame.readsFew && frame.fields === null && shadows === null && this.copyFew();
    values.farol_fewLights.value = few ? lights.recordCount : 0;
    if (few) lights.table.uploadedBytes = 0;
    else lights.upload(webgl);
    // null where unused: binding different textures from frame to frame would cost state changes
    values.farol_lightTable.value = few ? null : (frame.fields?.texture ?? lights.table.texture);
  }

  /** Copies directional and point lights to uniforms. @returns false for too many lights, or one with options that three lacks */
  private copyFew(): boolean {
    const { values } = this;
    const { recordCount, directional, table } = this.lights;
    const { data } = table;
    if (recordCount > FEW) return false;
    for (let i = 0; i < recordCount; i++) {
      const at = i * FLOATS_PER_RECORD;
      const sphere = i === 0 ? values.farol_fewSphere0 : values.farol_fewSphere1;
      const emission = i === 0 ? values.farol_fewEmission0 : values.farol_fewEmission1;
      for (let k = 0; k < 4; k++) {
        sphere.value[k] = data[at + LIGHT.sphere + k];
        emission.value[k] = data[at + LIGHT.emission + k];
      }
      // true for directional lights with a mask or extension record, and local lights other than plain point lights
      if (i < directional ? emission.value[3] !== 0 : emission.value[3] < 0) return false;
    }
    return true;
  }

  /** Clears the uniforms of disposed shadow textures: three would create textures again that are still bound. */
  freeMasks(): void {
    const { values } = this;
    values.farol_images.value = [null];
    values.farol_shadowAtlas.value = values.farol_lightAtlas.value = values.farol_tileShadows.value = null;
  }
}
