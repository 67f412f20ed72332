import { type Camera, Mesh, OrthographicCamera, PlaneGeometry, ShaderMaterial, Vector3 } from 'three';
import fragmentShader from './grid.frag.glsl?raw';
import vertexShader from './grid.vert.glsl?raw';

/** Of a view without perspective: the finest lines are so far apart, of its height, and no nearer. */
const FINEST = 1 / 60;

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);
const Z = new Vector3(0, 0, 1);
const front = new Vector3();

/**
 * The ground of the world: lines of a metre, red along x, blue along z. Without perspective the lines go by what is seen,
 * and in views from a side they are on the plane that faces the eye, behind everything.
 */
export class Grid extends Mesh<PlaneGeometry, ShaderMaterial> {
  /** @param extent - how far it is seen in perspective (m) */
  constructor(private readonly extent = 60) {
    super(
      new PlaneGeometry(2, 2).rotateX(-Math.PI / 2),
      new ShaderMaterial({
        name: 'Editor grid',
        vertexShader,
        fragmentShader,
        uniforms: {
          extent: { value: extent },
          step: { value: 1 },
          middle: { value: new Vector3() },
          axisU: { value: X.clone() },
          axisV: { value: Z.clone() },
          behind: { value: 0 },
        },
        transparent: true,
        depthWrite: false,
        toneMapped: false,
        side: 2,
        // before a floor at height 0, which it would flicker with
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -8,
      }),
    );
    this.frustumCulled = false;
    this.renderOrder = -1;
  }

  /** Before it is drawn: goes by the camera. */
  update(camera: Camera): void {
    const { extent, step, middle, axisU, axisV, behind } = this.material.uniforms;
    middle.value.setFromMatrixPosition(camera.matrixWorld);
    front.setFromMatrixColumn(camera.matrixWorld, 2);
    let [u, v] = [X, Z];
    if (camera instanceof OrthographicCamera) {
      const height = (camera.top - camera.bottom) / camera.zoom;
      const width = (camera.right - camera.left) / camera.zoom;
      if (Math.abs(front.z) > 0.9999) v = Y;
      else if (Math.abs(front.x) > 0.9999) u = Y;
      step.value = 10 ** Math.ceil(Math.log10(height * FINEST));
      // where the middle of the picture meets the plane
      const along = v === Y || u === Y ? 0 : Math.abs(front.y) > 0.01 ? -middle.value.y / front.y : 0;
      middle.value.addScaledVector(front, along);
      extent.value = (2 * Math.hypot(width, height)) / Math.max(0.1, v === Y || u === Y ? 1 : Math.abs(front.y));
    } else {
      step.value = 1;
      extent.value = this.extent;
    }
    const isWall = u === Y || v === Y;
    behind.value = isWall ? 1 : 0;
    axisU.value.copy(u);
    axisV.value.copy(v);
    // the wall goes through the origin of the world; distances are counted on it
    if (isWall) middle.value.addScaledVector(front, -middle.value.dot(front));
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
