import type { Component } from '@farol/engine';
import { type ReactNode, useState } from 'react';
import { removeComponents, setEnabled } from '../../model/edits';
import { SetFields } from '../../model/commands/SetFields';
import { useEditor } from '../../ui/EditorContext';
import type { IconName } from '../../ui/iconPaths';
import { MenuButton } from '../../ui/MenuButton';
import type { MenuEntry } from '../../ui/MenuEntry';
import { Toggle } from '../../ui/Toggle';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { FieldList } from './FieldList';
import { Section } from './Section';

const icons: Readonly<Record<string, IconName>> = {
  Transform: 'transform',
  ObjectRenderer: 'mesh',
  Light: 'point',
  Camera: 'camera',
  KeyController: 'keyboard',
  MouseController: 'mouse',
  RandomMovement: 'motion',
};

const words = (typeName: string): string => typeName.replaceAll(/([a-z])([A-Z])/g, '$1 $2');

/**
 * A component of the selected objects: its fields, whether it is enabled, and its menu.
 * @param props.components - the key says which: others need another section, so that an edit under way keeps its owners
 */
export function ComponentSection(props: { components: readonly Component[] }): ReactNode {
  const [components] = useState(props.components);
  const editor = useEditor();
  const { commands, document } = editor;
  useOwnersRevision(components);
  const [{ componentClass, typeName, enabled }] = components;
  const title = words(typeName);
  const isTransform = typeName === 'Transform';
  const mixed = components.some((component) => component.enabled !== enabled);

  const reset = (): void => {
    const fields = Object.entries(componentClass.fields);
    const edits = components.flatMap((owner) => fields.map(([name, field]) => ({ owner, name, value: field.default })));
    commands.run(new SetFields(`Reset ${title}`, edits));
  };
  const menu = (): MenuEntry[] => [
    { label: 'Reset', help: 'Gives every field its default.', icon: 'undo', run: () => editor.attempt(reset) },
    {
      label: 'Remove',
      icon: 'remove',
      disabled: isTransform,
      run: () => editor.attempt(() => commands.run(removeComponents(document.scene, components))),
    },
  ];

  return (
    <Section
      id={typeName}
      title={title}
      help={componentClass.help}
      icon={icons[typeName] ?? 'object'}
      controls={
        <>
          {!isTransform && (
            <Toggle
              value={mixed ? null : enabled}
              label={`${title} enabled`}
              description="Whether the component is switched on."
              onChange={(next) => commands.run(setEnabled(components, next))}
            />
          )}
          <MenuButton label={`${title} menu`} icon="more" iconOnly className="button small" entries={menu} />
        </>
      }
    >
      <FieldList owners={components} />
    </Section>
  );
}
