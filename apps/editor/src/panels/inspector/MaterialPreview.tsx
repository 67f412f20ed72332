import { t } from '@farol/editing';
import { type Component, ObjectRenderer } from '@farol/engine';
import { type ReactNode, useMemo, useState } from 'react';
import type { Material } from 'three';
import { addMaterial, duplicateMaterial, giveMaterial, valuesOfOwnMaterial } from '../../model/assetEdits';
import { Sequence } from '../../model/commands/Sequence';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { TurningBall } from '../../ui/TurningBall';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { Button } from '../../ui/Button';

/** The material that an object is drawn with; null when it has none, or several. */
function materialOf(component: Component): Material | null {
  const mesh = component instanceof ObjectRenderer ? component.three : null;
  return mesh && !Array.isArray(mesh.material) ? mesh.material : null;
}

/**
 * Preview sphere of an object's material, and buttons to make a library material of it. @param props.components -
 * ObjectRenderers, memoised
 */
export function MaterialPreview({ components }: { components: readonly Component[] }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  const [renderers] = useState(() => components.filter((each) => each instanceof ObjectRenderer));
  const [first] = renderers;
  useSignal(document.assetsChanged);
  const name = first.material;
  const shared = renderers.every((each) => each.material === name && each.shader === null);
  const asset = name === null || !shared ? null : document.assets.materialAsset(name);
  const owners = useMemo(() => [first, ...(asset ? [asset] : [])], [first, asset]);
  const revision = useOwnersRevision(owners);
  const hasMaterial = materialOf(first) !== null;

  const show = (material: string): void => document.assetSelection.set([material]);
  const attempt = (run: () => void) => (): void => editor.attempt(run);
  const make = attempt(() => {
    const materialName = t('{name} material', { name: first.gameObject.name });
    const made = addMaterial(document.scene, materialName, valuesOfOwnMaterial(first), renderers);
    commands.run(made.command);
    show(made.name);
  });
  const copy = attempt(() => {
    const made = duplicateMaterial(document.scene, asset!.name);
    const label = t('Give {name} a material of its own', { name: first.gameObject.name });
    commands.run(new Sequence(label, [() => made.command, () => giveMaterial(renderers, made.name, label)]));
    show(made.name);
  });

  return (
    <>
      {hasMaterial && renderers.length === 1 && (
        <TurningBall materialOf={() => materialOf(first)} revision={revision} label={t('A ball of this material')} />
      )}
      {shared && (
        <div className="material-bar">
          {asset ? (
            <>
              <Button icon="sliders" label={t('Edit material')} onClick={() => show(asset.name)} />
              <Button icon="duplicate" label={t('Make unique')} onClick={copy} />
            </>
          ) : (
            name === null && (
              <Button
                icon="contrast"
                label={t('Make material asset')}
                title={t('An asset of these values, which other objects can share, with every map')}
                onClick={make}
              />
            )
          )}
        </div>
      )}
    </>
  );
}
