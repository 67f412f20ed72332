import { type Color, Material, type MeshStandardMaterial, type Object3D, type Scene, type Texture } from 'three';
import type { LightField } from '../../light-fields/LightField';
import { surfacesOf } from '../../materials/surfacesOf';
import type { ReactiveMaterial } from '../../frame/ReactiveMask';
import type { LightTable } from '../../lighting/LightTable';
import type { RenderQueue } from '../../frame/RenderQueue';

type AnyMaterial = MeshStandardMaterial & { isShaderMaterial?: boolean };
type MovingTexture = Texture & { isVideoTexture?: boolean };

/**
 * Number that changes with the drawn materials: colours, opacity, roughness and the like, versions, textures. NaN, which never
 * equals itself, if the host's own shader or a video may change at any time.
 */
export function looksOf(queue: RenderQueue): number {
  return looksOfList(queue.opaque) + looksOfList(queue.transmissive) * 3 + looksOfList(queue.transparent) * 7;
}

/** Number that changes with the count of visible lights, ambient light, environment and background. */
export function surroundingsOf(lights: Pick<LightTable, 'visible' | 'ambient' | 'fields'>, scene: Object3D): number {
  const { environmentIntensity, backgroundIntensity, background } = scene as Scene;
  let sum = lights.visible + number(environmentIntensity) * 3 + number(backgroundIntensity) * 5;
  for (let i = 0; i < lights.ambient.length; i++) sum += lights.ambient[i] * (i + 7);
  if ((background as Color | null | undefined)?.isColor === true) sum += colour(background as Color) * 23;
  for (const field of lights.fields) sum += lookOfField(field as LightField);
  return sum;
}

/** Number that changes with a light field's settings; NaN where the GPU writes its lights. */
function lookOfField({ textures, color, intensity, count, matrixWorld: { elements } }: LightField): number {
  if (textures !== null) return Number.NaN;
  let sum = (colour(color) * 29 + 1) * intensity + count * 31;
  for (let i = 0; i < 15; i++) sum += elements[i] * (i + 37);
  return sum;
}

function looksOfList(items: RenderQueue['opaque']): number {
  let sum = items.length;
  for (let i = 0; i < items.length; i++) {
    const m = items[i].material as AnyMaterial & ReactiveMaterial;
    // skipped: the reactive mask covers the pixels of reactive materials
    if (m.isReactive === true) continue;
    if (items[i].shading === 'nodes' || m.isShaderMaterial || m.onBeforeCompile !== Material.prototype.onBeforeCompile)
      return Number.NaN;
    const own = m.id + m.version * 0.37 + m.opacity * 5 + colour(m.color) + colour(m.emissive) * 3;
    const numbers = number(m.emissiveIntensity) + number(m.roughness) * 3 + number(m.metalness) * 5 + texture(m.map);
    const surfaces = surfacesOf(m)?.colourVersion() ?? 0;
    sum += (own + numbers + surfaces) * ((i % 97) + 1);
  }
  return sum;
}

function colour(value: Color | undefined): number {
  return value === undefined ? 0 : value.r + value.g * 3 + value.b * 7;
}

function number(value: number | undefined): number {
  return value ?? 0;
}

function texture(value: MovingTexture | null | undefined): number {
  if (value === null || value === undefined) return 0;
  return value.isVideoTexture ? Number.NaN : value.version + value.offset.x + value.offset.y * 3 + value.rotation;
}
