import {
  type Box3,
  BufferAttribute,
  BufferGeometry,
  DynamicDrawUsage,
  GreaterDepth,
  LineBasicMaterial,
  LineSegments,
  type Matrix4,
  Object3D,
  Vector3,
} from 'three';

const a = new Vector3();
const b = new Vector3();

/** Indices of box corners in pairs joined by an edge; bits 0, 1, 2 of an index choose the larger x, y, z. */
const EDGES = [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7] as const;

/** Lines that are rebuilt each frame: opaque where visible, faint where hidden by geometry. */
export class LineSet {
  readonly three = new Object3D();

  private positions = new Float32Array(1024 * 3);
  private readonly geometry = new BufferGeometry();
  private readonly materials: LineBasicMaterial[];
  private vertices = 0;

  /** @param colour - CSS colour */
  constructor(colour: string) {
    const common = { color: colour, transparent: true, depthWrite: false, toneMapped: false, fog: false };
    this.materials = [
      new LineBasicMaterial({ ...common, opacity: 0.95 }),
      new LineBasicMaterial({ ...common, opacity: 0.35, depthFunc: GreaterDepth }),
    ];
    for (const material of this.materials) {
      const lines = new LineSegments(this.geometry, material);
      lines.frustumCulled = false;
      this.three.add(lines);
    }
  }

  get count(): number {
    return this.vertices / 2;
  }

  /** Removes all lines, before adding new ones. */
  begin(): void {
    this.vertices = 0;
  }

  /** Adds a line between two points (world). */
  line(from: Vector3, to: Vector3): void {
    if ((this.vertices + 2) * 3 > this.positions.length) {
      const larger = new Float32Array(this.positions.length * 2);
      larger.set(this.positions);
      this.positions = larger;
    }
    from.toArray(this.positions, this.vertices * 3);
    to.toArray(this.positions, this.vertices * 3 + 3);
    this.vertices += 2;
  }

  /** Adds the edges of a box. @param matrix - from the box's space to the world */
  box(box: Box3, matrix: Matrix4): void {
    for (let i = 0; i < EDGES.length; i += 2) {
      this.line(corner(box, EDGES[i], matrix, a), corner(box, EDGES[i + 1], matrix, b));
    }
  }

  /** Adds a circle: `centre` + cos t `u` + sin t `v`. */
  circle(centre: Vector3, u: Vector3, v: Vector3, segments = 64): void {
    for (let i = 0; i < segments; i++) {
      const t = (2 * Math.PI * i) / segments;
      const s = (2 * Math.PI * (i + 1)) / segments;
      a.copy(centre).addScaledVector(u, Math.cos(t)).addScaledVector(v, Math.sin(t));
      b.copy(centre).addScaledVector(u, Math.cos(s)).addScaledVector(v, Math.sin(s));
      this.line(a, b);
    }
  }

  /** Uploads the lines for the next frame. */
  end(): void {
    const attribute = this.geometry.getAttribute('position') as BufferAttribute | undefined;
    if (!attribute || attribute.array !== this.positions) {
      // a longer array needs a new GPU buffer
      this.geometry.dispose();
      this.geometry.setAttribute('position', new BufferAttribute(this.positions, 3).setUsage(DynamicDrawUsage));
    } else if (this.vertices > 0) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, this.vertices * 3);
      attribute.needsUpdate = true;
    }
    this.geometry.setDrawRange(0, this.vertices);
    this.three.visible = this.vertices > 0;
  }

  dispose(): void {
    this.geometry.dispose();
    for (const material of this.materials) material.dispose();
  }
}

function corner(box: Box3, bits: number, matrix: Matrix4, target: Vector3): Vector3 {
  const { min, max } = box;
  return target.set(bits & 1 ? max.x : min.x, bits & 2 ? max.y : min.y, bits & 4 ? max.z : min.z).applyMatrix4(matrix);
}
