import {
  BoxGeometry,
  Euler,
  Mesh,
  MeshStandardMaterial,
  MultiplyBlending,
  Quaternion,
  RawShaderMaterial,
  SubtractiveBlending,
  Vector3,
} from 'three';
import { DecalGeometry } from 'three/addons/geometries/DecalGeometry.js';

/** Material that three draws a decal with: nothing visible; Farol projects the decal. */
const nothing = new RawShaderMaterial({
  name: 'Farol decal',
  depthTest: false,
  depthWrite: false,
  vertexShader: 'void main() { gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }',
  fragmentShader: 'precision mediump float; void main() { gl_FragColor = vec4(0.0); }',
});
nothing.allowOverride = false;
const box = new BoxGeometry();

/**
 * Picture projected on the surfaces in a box: a unit cube around the object's origin, sized by `scale` (m). As in three's
 * DecalGeometry, the picture spans the box's x and y and is projected along z, seen from +z. Overlapping decals are drawn
 * by `renderOrder`. Without the effect `Decals` it is invisible.
 *
 * @example
 * const decal = new Decal(new MeshStandardMaterial({ map, normalMap, roughness: 0.4 }));
 * decal.position.copy(hit.point);
 * decal.lookAt(hit.point.clone().add(normal));
 * decal.scale.set(0.5, 0.5, 0.2);
 * scene.add(decal);
 */
export class Decal extends Mesh {
  readonly isDecal = true;
  /** Largest angle (rad) of a surface's normal to the box's z axis, 0 to π. Default π/2: not on surfaces that face away. */
  maximumAngle = Math.PI / 2;

  /**
   * @param surface - material of the decal, which the host owns: reads `color`, `opacity`, `map` (its alpha is coverage),
   *   `normalMap`, `normalScale`, `roughness`, `metalness` and `blending`. NormalBlending covers the surface below.
   *   AdditiveBlending, SubtractiveBlending and MultiplyBlending change only the surface's colour, by three's factors for
   *   premultiplied alpha, and its normal by a `normalMap`, not roughness and metalness. Other blendings count as NormalBlending
   */
  constructor(public surface: MeshStandardMaterial = new MeshStandardMaterial()) {
    super(box, nothing);
    this.name = 'Decal';
  }

  /**
   * Copy of the decal as a mesh, cut from another mesh by three's DecalGeometry, for techniques without a G-buffer: add it to
   * the scene in place of the decal. Valid while neither moves; the caller disposes its geometry and material. Blendings other
   * than NormalBlending blend with the lit colour of the surface.
   * @param mesh - mesh that the decal lies on; its matrices are updated
   */
  toMesh(mesh: Mesh): Mesh<DecalGeometry, MeshStandardMaterial> {
    this.updateWorldMatrix(true, false);
    mesh.updateWorldMatrix(true, false);
    const position = new Vector3();
    const size = new Vector3();
    const turn = new Quaternion();
    this.matrixWorld.decompose(position, turn, size);
    const geometry = new DecalGeometry(mesh, position, new Euler().setFromQuaternion(turn), size);
    const material = this.surface.clone();
    material.transparent = true;
    material.depthWrite = false;
    // three blends these modes only with premultiplied alpha
    material.premultipliedAlpha ||= material.blending === SubtractiveBlending || material.blending === MultiplyBlending;
    material.polygonOffset = true;
    material.polygonOffsetFactor = -4;
    return new Mesh(geometry, material);
  }
}
