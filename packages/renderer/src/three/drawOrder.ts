import { LessEqualDepth, type Material, NoBlending, NormalBlending } from 'three';

/** True for a material drawn as stock three draws opaque things by default: any pass may draw it in its own order. */
export function isPlainOpaque(material: Material): boolean {
  return (
    !material.transparent &&
    material.blending === NormalBlending &&
    !material.alphaToCoverage &&
    material.depthTest &&
    material.depthWrite &&
    material.depthFunc === LessEqualDepth &&
    material.colorWrite &&
    !material.stencilWrite &&
    !(material as Material & { wireframe?: boolean }).wireframe
  );
}

/**
 * True for an opaque material that must be drawn in three's order: its picture depends on things drawn before, or it
 * affects things drawn after otherwise than by its depth.
 */
export function isOrderSensitive(material: Material): boolean {
  return (
    !material.depthTest ||
    !material.depthWrite ||
    !material.colorWrite ||
    material.depthFunc !== LessEqualDepth ||
    material.stencilWrite ||
    (material.blending !== NormalBlending && material.blending !== NoBlending)
  );
}
