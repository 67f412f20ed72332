import { type Camera, Mesh, OrthographicCamera, PlaneGeometry, ShaderMaterial, Vector3 } from 'three';
import fragmentShader from './grid.frag.glsl?raw';
import vertexShader from './grid.vert.glsl?raw';

/** Smallest distance between lines in orthographic views, as a share of the view's height. */
const FINEST = 1 / 60;

const X = new Vector3(1, 0, 0);
const Y = new Vector3(0, 1, 0);
const Z = new Vector3(0, 0, 1);
const front = new Vector3();

/**
 * Ground grid: lines each metre, red along x, blue along z. In orthographic views the spacing adapts to the zoom; in
 * axis-aligned views the grid is on the plane facing the camera, behind everything.
 */
export class Grid extends Mesh<PlaneGeometry, ShaderMaterial> {
  /** @param extent - visible radius in perspective (m) */
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
        // the offset draws the grid in front of a floor at height 0, to avoid z-fighting
        polygonOffset: true,
        polygonOffsetFactor: -1,
        polygonOffsetUnits: -8,
      }),
    );
    this.frustumCulled = false;
    this.renderOrder = -1;
  }

  /** Adapts the grid to the camera; called before drawing. */
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
      // distance from the view's centre to the grid's plane, along the view direction
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
    // the plane goes through the origin; `middle`, from which the grid fades, must lie in the plane
    if (isWall) middle.value.addScaledVector(front, -middle.value.dot(front));
  }

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
