import { describeField, labelOfField, t } from '@farol/editing';
import { type Field, type FieldOwner, isFieldVisible } from '@farol/engine/fields';
import type { EditorApi } from '../../api/EditorApi';
import { addComponent } from '../../model/edits';
import { componentIcon, wordsOf } from '../inspector/componentIcons';
import { fieldSearchOf } from '../inspector/fieldSearch';
import type { PaletteItem } from './paletteItems';

/** Fields of an owner that the inspector shows. */
const shownFields = (owner: FieldOwner): [string, Field][] =>
  Object.entries(owner.fields).filter(
    ([name, { deprecated }]) => !deprecated && isFieldVisible(owner.fields, name, (other) => owner.getAuthored(other)),
  );

/** A line for each field of an owner; choosing a line shows the field in the inspector. */
function itemsOf(editor: EditorApi, owner: FieldOwner, group: string, show: () => void): PaletteItem[] {
  return shownFields(owner).map(([name, field]) => {
    const label = labelOfField(name, field);
    return {
      id: `field.${group}.${name}`,
      ...{ label, group, help: describeField(field), icon: 'sliders' },
      run() {
        show();
        editor.document.assetSelection.clear();
        fieldSearchOf(editor).find(`${label} ${owner === editor.document.scene.settings ? '' : group}`.trim(), true);
        editor.layout.open('inspector');
      },
    };
  });
}

/** Fields of the first selected object and of the scene. */
export function fieldItems(editor: EditorApi): PaletteItem[] {
  const { document } = editor;
  const { scene, selection, selectedObjects } = document;
  return [
    ...(selectedObjects[0]?.components ?? []).flatMap((component) =>
      itemsOf(editor, component, wordsOf(component.typeName), () => {}),
    ),
    ...itemsOf(editor, scene.settings, t('Scene'), () => selection.clear()),
  ];
}

/** Components that can be added to the selected objects. */
export function componentItems({ document, commands }: EditorApi): PaletteItem[] {
  const { scene, selectedObjects: objects } = document;
  if (objects.length === 0) return [];
  return [...scene.registry.types.values()]
    .filter((type) => !(type.unique && objects.every((object) => object.getComponent(type.typeName))))
    .map((type) => ({
      id: `component.${type.typeName}`,
      label: wordsOf(type.typeName),
      group: t('Add component'),
      help: t(type.help),
      icon: componentIcon(type),
      run: () => commands.run(addComponent(scene, objects, type)),
    }));
}
