import {
  Bone,
  BufferGeometry,
  DirectionalLight,
  Group,
  MeshBasicMaterial,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Skeleton,
  SkinnedMesh,
  type WebGLRenderer,
} from 'three';
import { describe, expect, it } from 'vitest';
import { duplicateSelected } from './duplicateSelected';
import { removeSelected } from './removeSelected';
import { Session } from './Session';

function group(name: string, ...children: Object3D[]): Group {
  const made = new Group();
  made.name = name;
  if (children.length > 0) made.add(...children);
  return made;
}

function makeSession(...children: Object3D[]): Session {
  const scene = new Scene();
  scene.add(...children);
  return new Session(scene, new PerspectiveCamera(), {} as WebGLRenderer);
}

/** Tree as text: 'a(b,c),d'. */
const treeOf = ({ children }: Object3D): string =>
  children.map((child) => child.name + (child.children.length > 0 ? `(${treeOf(child)})` : '')).join();

const find = (session: Session, names: string): Object3D[] =>
  [...names].map((name) => session.scene.getObjectByName(name)!);

describe('removeSelected', () => {
  it('takes several out, of those below one another the upper ones, and puts each back in its place', () => {
    const session = makeSession(group('a'), group('b', group('c'), group('d')), group('e'), group('f'));
    const before = treeOf(session.scene);
    session.selection.set(find(session, 'ecba'));
    removeSelected(session);
    expect(treeOf(session.scene)).toBe('f');
    expect(session.selection.items).toEqual([]);
    expect(session.commands.undoLabel).toBe('Deleted 3 objects');
    session.commands.undo();
    expect(treeOf(session.scene)).toBe(before);
    expect(session.selection.items.map(({ name }) => name).join('')).toBe('eba');
    session.commands.redo();
    expect(treeOf(session.scene)).toBe('f');
  });

  it('leaves the scene itself, and the camera that the page looks through', () => {
    const session = makeSession(group('a', group('b')));
    session.select(session.scene);
    removeSelected(session);
    expect(session.commands.undoLabel).toBe(null);
    find(session, 'b')[0].add(session.camera);
    session.selection.set(find(session, 'a'));
    session.attempt(() => removeSelected(session));
    expect(session.problem).toContain('drawn from this camera');
    expect(treeOf(session.scene)).toBe('a(b())');
  });
});

describe('duplicateSelected', () => {
  it('puts copies after their originals, selects them, and takes them away again', () => {
    const session = makeSession(group('a'), group('b', group('c')));
    session.selection.set(find(session, 'ab'));
    duplicateSelected(session);
    expect(treeOf(session.scene)).toBe('a,a,b(c),b(c)');
    expect(session.selection.items).toEqual([session.scene.children[1], session.scene.children[3]]);
    session.commands.undo();
    expect(treeOf(session.scene)).toBe('a,b(c)');
    expect(session.selection.items).toEqual(find(session, 'ab'));
    session.commands.redo();
    expect(treeOf(session.scene)).toBe('a,a,b(c),b(c)');
  });

  it('has a copied light shine on what the light shone on, and a copied skin move by bones of its own', () => {
    const target = group('t');
    const light = new DirectionalLight();
    light.target = target;
    const skin = new SkinnedMesh(new BufferGeometry(), new MeshBasicMaterial());
    const bone = new Bone();
    skin.add(bone);
    skin.bind(new Skeleton([bone]));
    const session = makeSession(target, light, skin);
    session.selection.set([light, skin]);
    duplicateSelected(session);
    const [copy, skinCopy] = session.selection.items as [DirectionalLight, SkinnedMesh];
    expect(copy.target).toBe(target);
    expect(skinCopy.skeleton.bones[0]).toBe(skinCopy.children[0]);
    expect(skinCopy.geometry).toBe(skin.geometry);
  });

  it('says which object has a class that cannot be copied, and changes nothing', () => {
    class Picky extends Group {
      constructor(readonly settings: { size: number }) {
        super();
        this.name = `picky ${settings.size}`;
      }
    }
    const session = makeSession(group('a'), new Picky({ size: 1 }));
    session.selection.set(session.scene.children);
    session.attempt(() => duplicateSelected(session));
    expect(session.problem).toContain('picky 1 cannot be duplicated');
    expect(session.scene.children).toHaveLength(2);
    expect(session.commands.undoLabel).toBe(null);
  });
});
