import type { GameObject, Scene, SceneChange } from '@farol/engine';
import { type FileObject, serializeHead, serializeObject } from '@farol/engine/files';
import type { Prefab } from '@farol/engine/prefabs';
import { NoteList } from './NoteList';
import {
  childrenKey,
  HEAD,
  objectKey,
  type PartChange,
  type PartKey,
  pieceKey,
  PREFAB_ORDER,
  prefabKey,
  type PrefabPart,
} from './parts';

/** Number of objects in each piece of a prefab. */
const PIECE = 100;

/**
 * Tracks the parts of a scene that changed since they were last read. Changes are only noted when made; parts are read
 * later, a few at a time, so that no frame is delayed.
 */
export class SceneDelta {
  private readonly objects = new NoteList();
  private readonly containers = new NoteList();
  private readonly prefabs = new NoteList();
  /** Pieces of the prefab being read; `objects` is null for pieces that no longer exist. */
  private pieces: { readonly key: PartKey; readonly objects: readonly FileObject[] | null }[] = [];
  /** Number of pieces read of each prefab. */
  private readonly pieceCounts = new Map<string, number>();
  /** Ids of objects still to be noted as changed, with descendants; parts are read only once this is empty. */
  private readonly trees = new NoteList();
  private headChanged = false;
  /**
   * Id of the container of each object when it was last noted, '' for the top; needed since a removal does not name it.
   * Objects not in the map are at the top, or in a container that is noted but not read yet.
   */
  private readonly containerOf = new Map<string, string>();

  constructor(private readonly scene: Scene) {}

  /** Whether no change is waiting to be read. */
  get isEmpty(): boolean {
    return (
      !this.headChanged &&
      this.pieces.length + this.trees.size + this.objects.size + this.containers.size + this.prefabs.size === 0
    );
  }

  noteAll(): void {
    this.headChanged = true;
    this.containers.add('');
    for (const { id } of this.scene.roots) this.trees.add(id);
    this.prefabs.add('');
    for (const { id } of this.scene.prefabs.list) this.prefabs.add(id);
  }

  noteAssets(): void {
    this.headChanged = true;
  }

  note(change: SceneChange): void {
    switch (change.kind) {
      case 'add':
        this.trees.add(change.gameObject.id);
        this.containerOf.set(change.gameObject.id, idOfParent(change.gameObject));
        this.containers.add(idOfParent(change.gameObject));
        break;
      case 'remove':
        this.containers.add(this.containerOf.get(change.gameObject.id) ?? '');
        change.gameObject.traverse(({ id }) => {
          this.objects.add(id);
          this.containers.add(id);
          this.containerOf.delete(id);
        });
        break;
      case 'move': {
        const { id } = change.gameObject;
        const parent = idOfParent(change.gameObject);
        // the old parent may be unknown and no longer contains the object, so the object is noted by itself
        if (!this.containerOf.has(id)) this.trees.add(id);
        this.containers.add(this.containerOf.get(id) ?? '').add(parent);
        this.containerOf.set(id, parent);
        this.objects.add(id);
        break;
      }
      case 'object':
      case 'component-add':
      case 'component-remove':
      case 'component-move':
      case 'component-class':
        this.objects.add(change.gameObject.id);
        break;
      case 'field':
      case 'enabled':
        this.objects.add(change.component.gameObject.id);
        break;
      case 'prefab':
        this.prefabs.add(change.id).add('');
        break;
      default:
        this.headChanged = true;
    }
    // adding or removing objects or cameras may change the scene's active camera, which is in the head
    if (change.kind === 'remove' || change.kind === 'add' || change.kind.startsWith('component'))
      this.headChanged = true;
  }

  /**
   * Reads parts until none is left or the time is up.
   * @param isOver - called after each part; whether the time is up
   * @param most - number of parts to read at most
   */
  read(isOver: () => boolean, most = Infinity): PartChange[] {
    const changes: PartChange[] = [];
    do {
      const tree = this.trees.take();
      if (tree !== undefined) this.noteNext(tree);
      else {
        const next = this.readNext();
        if (!next) break;
        changes.push(next);
      }
    } while (changes.length < most && !isOver());
    return changes;
  }

  private readNext(): PartChange | null {
    const piece = this.pieces.pop();
    if (piece) return [piece.key, piece.objects && JSON.stringify(piece.objects)];
    const objectId = this.objects.take();
    if (objectId !== undefined) {
      const object = this.scene.findById(objectId);
      return [objectKey(objectId), object && JSON.stringify(serializeObject(object))];
    }
    const container = this.containers.take();
    if (container !== undefined) {
      const list = container === '' ? this.scene.roots : this.scene.findById(container)?.children;
      const isGone = !list || (list.length === 0 && container !== '');
      return [childrenKey(container), isGone ? null : JSON.stringify(list.map((child) => child.id))];
    }
    const prefabId = this.prefabs.take();
    if (prefabId === '') return [PREFAB_ORDER, JSON.stringify(this.scene.prefabs.list.map((prefab) => prefab.id))];
    if (prefabId !== undefined) {
      const part = this.splitPrefab(prefabId, this.scene.prefabs.get(prefabId));
      return [prefabKey(prefabId), part && JSON.stringify(part)];
    }
    if (!this.headChanged) return null;
    this.headChanged = false;
    const { prefabs: _prefabs, objects: _objects, ...head } = serializeHead(this.scene);
    return [HEAD, JSON.stringify(head)];
  }

  private splitPrefab(id: string, prefab: Prefab | null): PrefabPart | null {
    const pieces = Math.ceil((prefab?.objects.length ?? 0) / PIECE);
    for (let i = 0; i < Math.max(pieces, this.pieceCounts.get(id) ?? 0); i++) {
      const objects = prefab && i < pieces ? prefab.objects.slice(i * PIECE, (i + 1) * PIECE) : null;
      this.pieces.push({ key: pieceKey(id, i), objects });
    }
    this.pieceCounts.set(id, pieces);
    return prefab && { id, name: prefab.name, pieces };
  }

  /** Records the state of an object, and queues its children. */
  private noteNext(id: string): void {
    const object = this.scene.findById(id);
    // the object was removed meanwhile
    if (!object) return;
    this.objects.add(id);
    this.containerOf.set(id, idOfParent(object));
    if (object.children.length > 0) this.containers.add(id);
    for (const child of object.children) this.trees.add(child.id);
  }
}

const idOfParent = (object: GameObject): string => object.parent?.id ?? '';
