import type {
  BatchedMesh,
  BufferAttribute,
  BufferGeometry,
  InstancedMesh,
  InterleavedBufferAttribute,
  Material,
  Mesh,
  MeshStandardMaterial,
  Object3D,
  Texture,
} from 'three';
import { Object3D as AnyObject } from 'three';
import { attributeVersion } from './attributeVersion';

type Caster = Mesh & Partial<InstancedMesh> & Partial<BatchedMesh> & { isSkinnedMesh?: boolean };
type CasterMaterial = Material & Partial<MeshStandardMaterial>;
type Batch = BatchedMesh & { _matricesTexture: Texture; _indirectTexture: Texture; _visibilityChanged: boolean };

let hash = 0;

/** FNV-1a, a number at a time. */
function mix(value: number): void {
  hash = Math.imul(hash ^ value, 16777619);
}

function mixTexture(texture: Texture | null | undefined): void {
  if (!texture) return;
  mix(texture.id);
  mix(texture.version);
}

function mixAttribute(attribute: BufferAttribute | InterleavedBufferAttribute | undefined): void {
  if (attribute !== undefined) mix(attributeVersion(attribute));
}

function mixGeometry(geometry: BufferGeometry): void {
  mix(geometry.id);
  mixAttribute(geometry.attributes.position as BufferAttribute | undefined);
  if (geometry.index !== null) mix(geometry.index.version);
  mix(geometry.drawRange.start);
  mix(geometry.drawRange.count);
}

function mixMaterial(m: CasterMaterial): void {
  mix(m.id);
  mix(m.version);
  mix((m.visible ? 1 : 0) + (m.wireframe ? 2 : 0) + (m.alphaToCoverage ? 4 : 0));
  mix(m.side * 8 + (m.shadowSide ?? 7));
  mix(m.alphaTest * 65536);
  if (m.alphaTest > 0) {
    mixTexture(m.map);
    mixTexture(m.alphaMap);
  }
  if (m.displacementMap) {
    mixTexture(m.displacementMap);
    mix((m.displacementScale ?? 0) * 65536);
    mix((m.displacementBias ?? 0) * 65536);
  }
}

/**
 * A number that changes, but for rare coincidences, when an object's shadow may do so though its world matrix did not:
 * its geometry, its instances, or what of its materials a shadow map sees.
 */
export function casterSignature(object: Object3D): number {
  const caster = object as Caster;
  hash = -2128831035;
  mixGeometry(caster.geometry);
  const { material } = caster;
  if (Array.isArray(material)) for (const one of material) mixMaterial(one as CasterMaterial);
  else mixMaterial(material as CasterMaterial);
  mix(object.layers.mask);
  if (caster.isInstancedMesh) {
    mix(caster.instanceMatrix!.version);
    mix(caster.count!);
  }
  if (caster.isBatchedMesh) {
    const batch = object as Batch;
    mix(batch._matricesTexture.version);
    mix(batch._indirectTexture.version);
    mix(batch._visibilityChanged ? 1 : 0);
  }
  return hash;
}

/** True for objects whose shadow may change in ways that nobody tells: skinned, morphed, with shaders of their own. */
export function isAnimatedCaster(object: Object3D): boolean {
  const caster = object as Caster;
  if (caster.isSkinnedMesh || caster.morphTargetInfluences?.length) return true;
  if (object.customDepthMaterial !== undefined || object.customDistanceMaterial !== undefined) return true;
  if (object.onBeforeShadow !== AnyObject.prototype.onBeforeShadow && !caster.isBatchedMesh) return true;
  const { material } = caster;
  return Array.isArray(material) ? material.some(isAnimatedMaterial) : isAnimatedMaterial(material);
}

function isAnimatedMaterial(material: Material): boolean {
  return material.clipShadows && material.clippingPlanes !== null && material.clippingPlanes.length > 0;
}
