import { Mesh, PlaneGeometry, ShaderMaterial } from 'three';
import fragmentShader from './grid.frag.glsl?raw';
import vertexShader from './grid.vert.glsl?raw';

/** The ground of the world: lines of a metre, red along x, blue along z. */
export class Grid extends Mesh<PlaneGeometry, ShaderMaterial> {
  /** @param extent - how far it is seen (m) */
  constructor(extent = 60) {
    super(
      new PlaneGeometry(2, 2).rotateX(-Math.PI / 2),
      new ShaderMaterial({
        name: 'Editor grid',
        vertexShader,
        fragmentShader,
        uniforms: { extent: { value: extent } },
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

  override dispose(): void {
    this.geometry.dispose();
    this.material.dispose();
  }
}
