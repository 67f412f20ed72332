import { Euler, type EulerOrder, type Object3D, type Quaternion } from 'three';

/**
 * Euler angles of a quaternion, computed when read. three recomputes the angles at each change of the quaternion, which
 * is most of the cost of moving a body.
 */
class LazyEuler extends Euler {
  /** Whether the quaternion changed since the angles were computed. */
  isStale = false;

  // `declare` emits no initial values, which would replace those that Euler's constructor sets
  declare private ownX: number;
  declare private ownY: number;
  declare private ownZ: number;
  declare private ownOrder: EulerOrder;

  constructor(
    private readonly source: Quaternion,
    order: EulerOrder,
  ) {
    super(0, 0, 0, order);
  }

  // three's Euler, and methods that take one, use these private properties; reading one computes stale angles
  get _x(): number {
    this.refresh();
    return this.ownX;
  }

  set _x(value: number) {
    this.refresh();
    this.ownX = value;
  }

  get _y(): number {
    this.refresh();
    return this.ownY;
  }

  set _y(value: number) {
    this.refresh();
    this.ownY = value;
  }

  get _z(): number {
    this.refresh();
    return this.ownZ;
  }

  set _z(value: number) {
    this.refresh();
    this.ownZ = value;
  }

  get _order(): EulerOrder {
    return this.ownOrder;
  }

  set _order(value: EulerOrder) {
    // as in three: the angles stay, and the quaternion follows the new order
    this.refresh();
    this.ownOrder = value;
  }

  private refresh(): void {
    if (!this.isStale) return;
    this.isStale = false;
    this.setFromQuaternion(this.source, this.ownOrder, false);
  }
}

/** Makes an object compute its `rotation` angles from the quaternion only when read. */
export function makeRotationLazy(object: Object3D): void {
  const { quaternion } = object;
  const rotation = new LazyEuler(quaternion, object.rotation.order);
  rotation._onChange(() => void quaternion.setFromEuler(rotation, false));
  quaternion._onChange(() => (rotation.isStale = true));
  Object.defineProperty(object, 'rotation', { configurable: true, enumerable: true, value: rotation });
}
