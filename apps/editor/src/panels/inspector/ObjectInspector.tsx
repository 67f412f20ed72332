import { t } from '@farol/editing';
import type { Component, GameObject } from '@farol/engine';
import { memo, type ReactNode, useMemo } from 'react';
import { addComponent, renameObject, setActive } from '../../model/edits';
import { changeStatic } from '../../actions/changeStatic';
import { addLibraryScript } from '../../model/library/addLibraryScript';
import { libraryScripts } from '../../model/library/scripts';
import { scriptOfType } from '../../model/scriptNames';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { SearchMenu, type SearchMenuItem } from '../../ui/SearchMenu';
import { TextInput } from '../../ui/TextInput';
import { Toggle } from '../../ui/Toggle';
import { objectIcon } from '../hierarchy/objectIcon';
import { componentIcon, wordsOf } from './componentIcons';
import { PrefabBar } from '../prefab/PrefabBar';
import { ComponentSection } from './ComponentSection';
import { TagsField } from './TagsField';

/** The components that all objects have: a group for each type, in the first object's order. */
function sharedComponents(objects: readonly GameObject[]): (readonly Component[])[] {
  const [first, ...others] = objects;
  if (others.length === 0) return first.components.map((component) => [component]);
  const types = [...new Set(first.components.map(({ typeName }) => typeName))];
  return types.flatMap((type) => {
    const group = objects.flatMap((object) => object.getComponent(type) ?? []);
    return group.length === objects.length ? [group] : [];
  });
}

/** Menu value for a new script; not the name of a component type. */
const NEW_SCRIPT = 'new script…';

const keys = new WeakMap<Component, number>();
let count = 0;

/** Unique number of a component, since another component may later have the same id. */
function keyOf(component: Component): number {
  let key = keys.get(component);
  if (key === undefined) keys.set(component, (key = count++));
  return key;
}

/**
 * Types left out of the Add menu: every object has a Transform; Animator exists for older files, and is replaced by
 * Animation.
 */
const notAdded: ReadonlySet<string> = new Set(['Transform', 'Animator']);

/**
 * Inspector of the selected GameObjects: name, whether they are active, and their components. @param props.ids - at
 * least one
 */
export const ObjectInspector = memo(function ObjectInspector({ ids }: { ids: readonly string[] }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  const structure = useSignal(document.structure);
  const { objects, groups } = useMemo(() => {
    const found = ids.flatMap((id) => document.scene.findById(id) ?? []);
    return { objects: found, groups: found.length > 0 ? sharedComponents(found) : [] };
    // oxlint-disable-next-line react-hooks/exhaustive-deps -- the revision stands for the components
  }, [document, structure, ids]);
  const [first] = objects;
  // the objects were removed, and the selection is about to change
  if (!first) return null;
  const isOne = objects.length === 1;
  const mixed = objects.some(({ active }) => active !== first.active);

  const types = document.scene.registry.types;
  const items = (): SearchMenuItem[] => [
    ...[...types.values()]
      .filter(({ typeName }) => !notAdded.has(typeName))
      .map((type) => ({
        value: type.typeName,
        label: wordsOf(type.typeName),
        help: t(type.help),
        icon: scriptOfType(document.scene, type.typeName) === null ? componentIcon(type) : 'code',
        disabled: type.unique && objects.every((object) => object.getComponent(type.typeName)),
      })),
    ...Object.keys(libraryScripts)
      .filter((name) => !types.has(name))
      .map((name) => ({ value: name, label: t(name), help: t('A script of the library.'), icon: 'code' as const })),
    { value: NEW_SCRIPT, label: t('New script…'), help: t('A component of your own, written here.'), icon: 'code' },
  ];
  const add = (name: string): void =>
    editor.attempt(async () => {
      if (!types.has(name) && name !== NEW_SCRIPT) return commands.run(addLibraryScript(document.scene, objects, name));
      if (name === 'CharacterController' && objects.some((object) => object.getComponent('Camera'))) {
        const { addCharacter } = await import('../../model/addPhysics');
        return commands.run(addCharacter(document.scene, objects, ids));
      }
      if (name !== NEW_SCRIPT) return commands.run(addComponent(document.scene, objects, types.get(name)!));
      const { newScript } = await import('../../files/newScript');
      newScript(editor, t('Script'), objects);
    });

  return (
    <>
      <div className="object-scroll">
        <div className="object-header">
          <Icon name={isOne ? objectIcon(first) : 'duplicate'} />
          {isOne ? (
            <TextInput
              key={first.id}
              value={first.name}
              label={t('Name')}
              onCommit={(name) => name.trim() && commands.run(renameObject(first, name.trim()))}
            />
          ) : (
            <span className="object-count">{t('{count} objects', { count: objects.length })}</span>
          )}
          <span className="object-static" aria-hidden="true">
            {t('Static')}
          </span>
          <Toggle
            value={objects.some(({ isStatic }) => isStatic !== first.isStatic) ? null : first.isStatic}
            label={t('Static')}
            description={t('The object stays where it is: baked light gives it a lightmap.')}
            onChange={(isStatic) => editor.attempt(() => changeStatic(editor, objects, isStatic))}
          />
          <span className="object-static" aria-hidden="true">
            {t('Active')}
          </span>
          <Toggle
            value={mixed ? null : first.active}
            label={t('Active')}
            description={t('Whether the object and all below it are active: shown, lit, moving.')}
            onChange={(active) => commands.run(setActive(objects, active))}
          />
        </div>
        {isOne && first.prefabLink && <PrefabBar object={first} />}
        {groups.map((components) => (
          <ComponentSection key={components.map(keyOf).join()} components={components} />
        ))}
        <TagsField objects={objects} />
      </div>
      <div className="add-component">
        <SearchMenu label={t('Add component')} icon="add" className="button wide" items={items} onChoose={add} />
      </div>
    </>
  );
});
