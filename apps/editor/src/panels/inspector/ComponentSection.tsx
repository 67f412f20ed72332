import { t } from '@farol/editing';
import { builtinComponents, type Component } from '@farol/engine';
import { type ReactNode, useState } from 'react';
import { setEnabled } from '../../model/edits';
import { scriptOfType } from '../../model/scriptNames';
import { useEditor } from '../../ui/EditorContext';
import { IconButton } from '../../ui/IconButton';
import { lateComponent } from '../../ui/lateComponent';
import { MenuButton } from '../../ui/MenuButton';
import type { MenuEntry } from '../../api/MenuEntry';
import { Toggle } from '../../ui/Toggle';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { AnimationBar } from './AnimationBar';
import { componentEntries } from './componentEntries';
import { componentIcon, wordsOf } from './componentIcons';
import { FieldList } from './FieldList';
import { MaterialPreview } from './MaterialPreview';
import { ModelBar } from './ModelBar';
import { ObjectSurfaceBar } from './ObjectSurfaceBar';
import { Section } from './Section';
import { TriggerProblems } from './TriggerProblems';

const LateLightBar = lateComponent(async () => (await import('./LightBar')).LightBar);
const LateSunBar = lateComponent(async () => (await import('./sun/SunBar')).SunBar);

/**
 * A component of the selected objects: its fields, whether it is enabled, and its menu.
 * @param props.components - read once, so that an edit in progress keeps its owners; the React key must change with
 *   them
 */
export function ComponentSection(props: { components: readonly Component[] }): ReactNode {
  const [components] = useState(props.components);
  const editor = useEditor();
  const { commands } = editor;
  useOwnersRevision(components);
  const [{ componentClass, typeName, enabled }] = components;
  const title = wordsOf(typeName);
  const isTransform = typeName === 'Transform';
  const mixed = components.some((component) => component.enabled !== enabled);

  // built-in components have no script
  const script = builtinComponents.types.has(typeName) ? null : scriptOfType(editor.document.scene, typeName);
  const menu = (): MenuEntry[] => componentEntries(editor, components);

  return (
    <Section
      id={typeName}
      title={title}
      help={t(componentClass.help)}
      icon={script === null ? componentIcon(componentClass) : 'code'}
      controls={
        <>
          {script !== null && (
            <IconButton
              icon="code"
              size={13}
              label={t('Edit script {name}', { name: script })}
              onClick={() => editor.openScript(script)}
            />
          )}
          {!isTransform && (
            <Toggle
              value={mixed ? null : enabled}
              label={t('{title} enabled', { title })}
              description={t('Whether the component is switched on.')}
              onChange={(next) => commands.run(setEnabled(components, next))}
            />
          )}
          <MenuButton
            label={t('{title} menu', { title })}
            icon="more"
            iconOnly
            className="button small"
            entries={menu}
          />
        </>
      }
    >
      {typeName === 'Light' && <LateLightBar components={components} />}
      <FieldList owners={components} />
      <ObjectSurfaceBar components={components} />
      {typeName === 'EventTrigger' && <TriggerProblems components={components} />}
      {typeName === 'ModelRenderer' && <ModelBar components={components} />}
      {typeName === 'Animation' && <AnimationBar components={components} />}
      {typeName === 'SunAndMoon' && <LateSunBar components={components} />}
      {typeName === 'ObjectRenderer' && <MaterialPreview components={components} />}
    </Section>
  );
}
