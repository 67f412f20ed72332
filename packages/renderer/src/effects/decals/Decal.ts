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

/** Geometry and material that three draws for a decal: nothing visible; Farol projects it. */
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
 * A picture that is put on whatever surface lies in its box: a unit cube round the object's origin, sized by `scale` (m). As
 * three's DecalGeometry has it, the picture lies in the box's x and y and is thrown along z, seen from +z. Overlapping
 * decals are drawn by `renderOrder`. Without the effect `Decals` nothing of it is seen.
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
  /** Largest angle (rad) of a surface's normal to the box's z axis, 0 to π. Default π/2: what faces away is left out. */
  maximumAngle = Math.PI / 2;

  /**
   * @param surface - what it is made of: `color`, `opacity`, `map` (its alpha is coverage), `normalMap`, `normalScale`,
   *   `roughness`, `metalness` and `blending` count; it stays the host's. NormalBlending covers the surface.
   *   AdditiveBlending, SubtractiveBlending and MultiplyBlending change its colour alone, as three's factors for
   *   premultiplied alpha have it, and leave it its roughness and metalness; a `normalMap` bends it all the same. Other
   *   blendings count as NormalBlending
   */
  constructor(public surface: MeshStandardMaterial = new MeshStandardMaterial()) {
    super(box, nothing);
    this.name = 'Decal';
  }

  /**
   * Copy of the decal as a mesh, cut from another mesh by three's DecalGeometry, for techniques without a G-buffer: add
   * it to the scene in place of the decal. Right as long as neither moves; its geometry and material are the caller's
   * to dispose. Where it blends otherwise than NormalBlending, it does so with the lit colour of what is behind it.
   * @param mesh - that the decal lies on; matrices are brought up to date
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
