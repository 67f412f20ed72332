import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { Camera, type Scene } from '@farol/engine';
import { SetProperty } from '../../model/commands/SetProperty';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { SelectBox } from '../../ui/SelectBox';
import { TextInput } from '../../ui/TextInput';
import { PhysicsSection } from './PhysicsSection';
import { PictureSections } from './PictureSections';
import { Section } from './Section';

/** Settings of the scene, shown while no object is selected. */
export function SceneInspector(): ReactNode {
  const { document, commands } = useEditor();
  useSignal(document.structure);
  const { scene } = document;
  const set = <K extends 'name' | 'activeCamera'>(label: string, property: K, value: Scene[K]): void =>
    commands.run(new SetProperty<K, Scene[K]>(label, [scene], property, value));
  const cameras = scene.componentsOf(Camera).map((camera) => ({ value: camera.id, label: camera.gameObject.name }));
  return (
    <>
      <div className="object-header">
        <Icon name="scene" />
        <TextInput
          value={scene.name}
          label={t('Name of the scene')}
          onCommit={(typed) => {
            const name = typed.trim();
            if (name) set(t('Renamed the scene to {name}', { name }), 'name', name);
          }}
        />
      </div>
      <p className="scene-note">{t('Nothing is selected: these are the settings of the whole scene.')}</p>
      <Section id="Scene" title={t('Scene')} help={t('Settings of the whole scene.')} icon="scene">
        {cameras.length > 0 && (
          <div className="field" data-help={t('The camera that the finished scene is seen with.')}>
            <span className="field-label">{t('Camera')}</span>
            <div className="field-editor">
              <SelectBox
                value={scene.activeCamera?.id ?? null}
                options={cameras}
                label={t('Active camera')}
                onChange={(id) => {
                  const camera = scene.componentsOf(Camera).find((each) => each.id === id) ?? null;
                  const name = camera?.gameObject.name ?? t('none');
                  set(t('Set the camera of the scene to {name}', { name }), 'activeCamera', camera);
                }}
              />
            </div>
          </div>
        )}
      </Section>
      <PictureSections settings={scene.settings} />
      <PhysicsSection settings={scene.settings} />
    </>
  );
}
