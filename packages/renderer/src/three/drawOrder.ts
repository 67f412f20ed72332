import { LessEqualDepth, type Material, NoBlending, NormalBlending } from 'three';

/** True for a material with three's default state of opaque materials: any pass may draw it in any order. */
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
 * True for an opaque material that must be drawn in three's order: it depends on earlier draws, or affects later ones other than
 * by its depth.
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
