import type { Vector3Tuple } from '@farol/editing/fields';
import { Box3, type BufferGeometry, Color, DynamicDrawUsage, InstancedMesh, type Material, Sphere } from 'three';
import type { InstanceOwner } from '../../core/gameObjectOf';
import { IndexedList } from '../../core/IndexedList';
import type { Component } from '../../core/Component';
import type { GameObject } from '../../core/GameObject';
import { fitBounds } from '../ObjectSurface';

/** A component that is drawn as an instance: an ObjectRenderer. */
export interface InstanceMember extends Component {
  readonly render: boolean;
  /** Linear colour of the instance. */
  readonly colour: Vector3Tuple;
  readonly castShadow: boolean;
  readonly receiveShadow: boolean;
}

/** The three mesh of a group; a ray that hits one of its instances finds the GameObject by `gameObjectOf`. */
class GroupMesh extends InstancedMesh implements InstanceOwner {
  readonly drawn: GameObject[] = [];

  gameObjectAt(instanceId: number): GameObject | null {
    return this.drawn[instanceId] ?? null;
  }
}

const colour = new Color();
const one = new Sphere();
const box = new Box3();

/** ObjectRenderers of one geometry and one material, drawn in one call. */
export class InstanceGroup {
  readonly members = new IndexedList<InstanceMember>();

  private mesh: GroupMesh | null = null;

  constructor(
    private readonly geometry: BufferGeometry,
    private readonly material: Material,
    private readonly shadows: { readonly cast: boolean; readonly receive: boolean },
  ) {}

  /** Instanced mesh of the last `update`; replaced when the group outgrows its capacity. */
  get three(): InstancedMesh | null {
    return this.mesh;
  }

  /** Copies matrices and colours of the members to the instanced mesh. Call when world matrices are up to date. */
  update(): InstancedMesh {
    const members = this.members.array;
    const mesh = this.meshFor(members.length);
    const colours = mesh.instanceColor!;
    if (this.geometry.boundingSphere === null) this.geometry.computeBoundingSphere();
    box.makeEmpty();
    let count = 0;
    let recoloured = false;
    for (let i = 0; i < members.length; i++) {
      const member = members[i];
      if (!member.isActive || !member.render) continue;
      const { matrixWorld } = member.gameObject.object3D;
      mesh.setMatrixAt(count, matrixWorld);
      addSphere(one.copy(this.geometry.boundingSphere!).applyMatrix4(matrixWorld));
      const [r, g, b] = member.colour;
      if (
        colours.getX(count) !== Math.fround(r) ||
        colours.getY(count) !== Math.fround(g) ||
        colours.getZ(count) !== Math.fround(b)
      ) {
        mesh.setColorAt(count, colour.setRGB(r, g, b));
        recoloured = true;
      }
      mesh.drawn[count++] = member.gameObject;
    }
    mesh.drawn.length = count;
    mesh.count = count;
    mesh.instanceMatrix.needsUpdate = true;
    if (recoloured) colours.needsUpdate = true;
    mesh.boundingBox = null;
    // a bounding sphere of all instances, for culling and for tests against the far plane
    box.getBoundingSphere((mesh.boundingSphere ??= new Sphere()));
    fitBounds(mesh);
    return mesh;
  }

  dispose(): void {
    this.mesh?.removeFromParent();
    this.mesh?.dispose();
    this.mesh = null;
  }

  private meshFor(count: number): GroupMesh {
    if (this.mesh && this.mesh.instanceMatrix.count >= count) return this.mesh;
    const { parent } = this.mesh ?? {};
    this.dispose();
    const mesh = new GroupMesh(this.geometry, this.material, Math.max(16, 2 ** Math.ceil(Math.log2(count))));
    mesh.name = 'Instances';
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.setColorAt(0, colour.setRGB(1, 1, 1));
    mesh.castShadow = this.shadows.cast;
    mesh.receiveShadow = this.shadows.receive;
    mesh.matrixAutoUpdate = false;
    parent?.add(mesh);
    this.mesh = mesh;
    return mesh;
  }
}

/** Extends `box` by a sphere. NaN makes the box NaN: the group is then never culled. */
function addSphere({ center: { x, y, z }, radius }: Sphere): void {
  const { min, max } = box;
  min.set(Math.min(min.x, x - radius), Math.min(min.y, y - radius), Math.min(min.z, z - radius));
  max.set(Math.max(max.x, x + radius), Math.max(max.y, y + radius), Math.max(max.z, z + radius));
}
