import type { Camera, Light } from 'three';
import type { DataTable } from '../../gpu/DataTable';
import { isAreaLight } from '../../lights/classifyLight';
import { ELSEWHERE } from '../../lights/lightRecord';
import type { LightLayers } from '../LightLayers';
import { AreaShadowLight } from '../slots/AreaShadowLight';
import type { LightSlots } from '../slots/LightSlots';
import type { ShadowSlot } from '../slots/ShadowSlot';
import type { MaskShaders } from './MaskShaders';
import { maskFeatures, maskFeaturesOf, maskLoopOf } from './maskFeatures';
import { RECORDS_PER_MASK } from './maskLayout';
import type { PictureSize } from '../../lights/PictureSize';
import { shadowLookupOf, writeLayerMask, writeMask } from './maskRecord';

/** Assigns mask records: per-light data of shadow map, cookie and layers in the light table. */
export class MaskRecords {
  records = 0;
  /** Mask record of each light without shadow map or cookie that does not reach all layers. */
  private readonly layered = new Map<Light, number>();

  constructor(
    private readonly slots: LightSlots,
    private readonly layers: LightLayers,
    private readonly shaders: MaskShaders,
  ) {}

  get count(): number {
    return this.records / RECORDS_PER_MASK;
  }

  begin(): void {
    this.records = 0;
    if (this.layered.size > 0) this.layered.clear();
  }

  /** Adds a light without shadow map or cookie that does not reach all layers. */
  addLayered(light: Light): void {
    if (this.layers.separates(light)) this.layered.set(light, -1);
  }

  /**
   * Gives a light with shadow map or cookie its mask record. Call once `hasShadow` is known.
   * @param type - type of shadow maps, as `shadowMap.type`
   */
  assign(slot: ShadowSlot, type: number): void {
    const isMasked =
      slot.hasShadow || slot.cookie !== null || slot.profile !== null || this.layers.separates(slot.light);
    slot.record = isMasked ? this.records : -1;
    if (!isMasked) return;
    this.records += RECORDS_PER_MASK;
    this.shaders.need(maskFeaturesOf(slot, type));
  }

  /** Gives the lights of `addLayered` records, after all other masks, and adapts shaders to all masks of the frame. */
  end(): void {
    for (const light of this.layered.keys()) {
      this.shaders.need(maskFeatures.unshadowed | maskLoopOf(light));
      this.layered.set(light, this.records);
      this.records += RECORDS_PER_MASK;
    }
    this.shaders.adapt(this.records > 0, this.layers.reference !== 0);
  }

  recordOf(light: Light): number {
    const lit = isAreaLight(light) ? AreaShadowLight.of(light) : light;
    const slot = lit && this.slots.litSlotOf(lit);
    if (slot === undefined) return this.layered.get(light) ?? -1;
    return slot.record >= 0 && slot.hasLeftMap ? slot.record + ELSEWHERE : slot.record;
  }

  /**
   * @param type - type of shadow maps, as `shadowMap.type`
   * @param reversed - whether the depth buffer is reversed
   * @param picture - size (pixels)
   */
  write(table: DataTable, first: number, camera: Camera, type: number, reversed: boolean, picture: PictureSize): void {
    for (const slot of this.slots.lit) {
      if (slot.record < 0) continue;
      const layers = this.layers.separates(slot.light) ? slot.light.layers.mask : 0;
      writeMask(table, first + slot.record, slot, shadowLookupOf(slot, type), camera, reversed, layers, picture);
    }
    for (const [light, record] of this.layered) writeLayerMask(table, first + record, light.layers.mask);
  }
}
