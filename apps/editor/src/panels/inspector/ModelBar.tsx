import { t } from '@farol/editing';
import { type Component, ModelRenderer } from '@farol/engine';
import { type ReactNode, useState } from 'react';
import { unpackModel } from '../../actions/materials';
import { whyNotUnpack } from '../../model/unpackModels';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { ModelTree } from '../material/ModelTree';
import { useOwnersRevision } from '../../ui/useOwnersRevision';
import { Button } from '../../ui/Button';

/** Buttons for models that are drawn as one object, such as unpacking. @param props.components - ModelRenderers, memoised */
export function ModelBar({ components }: { components: readonly Component[] }): ReactNode {
  const editor = useEditor();
  const { document } = editor;
  useSignal(document.assetsChanged);
  const [isInside, showInside] = useState(false);
  useOwnersRevision(components);
  const renderers = components.filter((each) => each instanceof ModelRenderer);
  const { assets } = document;
  const [{ model }] = renderers;
  if (model === null || !renderers.every((each) => each.model !== null && assets.isReady('model', each.model)))
    return null;
  const problem = renderers.map((each) => whyNotUnpack(assets, each.model!, each.parts)).find((each) => each !== null);
  const help = t('Turns the model into a tree: meshes, lights and cameras as objects, materials as assets');
  return (
    <div className="material-bar">
      <Button
        icon="tree"
        label={t('Unpack')}
        disabled={problem !== undefined}
        title={problem ?? help}
        onClick={() => editor.attempt(() => unpackModel.run(editor))}
      />
      <Button
        icon="search"
        label={t('Look inside')}
        title={t('The objects and clips of the model')}
        aria-expanded={isInside}
        onClick={() => showInside(!isInside)}
      />
      {problem !== undefined && <p className="model-problem">{problem}</p>}
      {isInside && (
        <div className="model-look">
          <ModelTree model={assets.model(model)} />
          <button type="button" className="button" onClick={() => document.assetSelection.set([model])}>
            <span>{t('Show {name} in the library', { name: model })}</span>
          </button>
        </div>
      )}
    </div>
  );
}
