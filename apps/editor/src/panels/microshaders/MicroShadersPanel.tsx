import { t } from '@farol/editing';
import { type ReactNode, useEffect, useState, useSyncExternalStore } from 'react';
import '../../ui/code/code.css';
import { CodeEditor } from '../../ui/code/CodeEditor';
import { glslLanguage } from '../../ui/code/glslLanguage';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { ChunkBar } from './ChunkBar';
import { ChunkErrors } from './ChunkErrors';
import { ChunkList } from './ChunkList';
import { ChunkUses } from './ChunkUses';
import './microshaders.css';
import { useMicroShaderUses } from './useMicroShaderUses';

/** The microshaders: which there are, where they are used, and their texts, compiled while they are typed. */
export function MicroShadersPanel(): ReactNode {
  const editor = useEditor();
  const { microShaders } = editor;
  useSignal(microShaders.changed);
  useSignal(editor.document.structure);
  const uses = useMicroShaderUses();
  const place = useSyncExternalStore(editor.microShaderPlace.subscribe, () => editor.microShaderPlace.current);
  const [shown, setShown] = useState(place?.name ?? 'lightAttenuation');
  const [lastPlace, setLastPlace] = useState(place);
  if (place !== lastPlace) {
    setLastPlace(place);
    if (place) setShown(place.name);
  }
  const { names } = microShaders;
  const name = names.includes(shown) ? shown : names[0];
  // oxlint-disable-next-line react/exhaustive-effect-dependencies -- another chunk: what was edited is a step
  useEffect(() => () => microShaders.finish(), [microShaders, name]);

  const problem = microShaders.problem(name);
  const errors = problem?.entries.filter(({ chunk }) => chunk === name) ?? none;
  return (
    <section className="panel microshaders" aria-label={t('Microshaders')}>
      <ChunkList names={names} current={name} uses={uses} onChoose={(next) => editor.openMicroShader(next)} />
      <div className="chunk">
        <ChunkBar name={name} onOpen={(next) => editor.openMicroShader(next)} />
        <CodeEditor
          name={name}
          text={microShaders.textOf(name)}
          label={t('Text of the microshader')}
          problems={errors}
          language={glslLanguage}
          goTo={place?.name === name && place.line > 0 ? place : null}
          onInput={(text) => microShaders.edit(name, text)}
          onLeave={() => microShaders.finish()}
        />
        {problem && <ChunkErrors name={name} problem={problem} />}
      </div>
      <ChunkUses name={name} uses={uses} />
    </section>
  );
}

const none: readonly never[] = [];
