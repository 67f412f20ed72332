import { t } from '@farol/editing';
import { type ReactNode, useCallback, useEffect, useState, useSyncExternalStore } from 'react';
import '../../ui/code/code.css';
import { CodeEditor } from '../../ui/code/CodeEditor';
import { glslLanguage } from '../../ui/code/glslLanguage';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { ChunkBar } from './ChunkBar';
import { ChunkErrors } from './ChunkErrors';
import { ChunkList } from './ChunkList';
import { ChunkUses } from './ChunkUses';
import './microshaders.css';
import { SurfaceBar } from './SurfaceBar';
import { SurfaceUses } from './SurfaceUses';
import { SURFACE, surfaceEditingOf } from '../../microshaders/SurfaceEditing';
import { useMicroShaderUses } from './useMicroShaderUses';

/** Microshaders and surfaces: list, uses, and an editor that compiles while the user types. */
export function MicroShadersPanel(): ReactNode {
  const editor = useEditor();
  const { microShaders } = editor;
  const surfaces = surfaceEditingOf(editor);
  useSignal(microShaders.changed);
  useSignal(surfaces.changed);
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
  const shownSurface = surfaces.names.find((each) => SURFACE + each === shown) ?? null;
  const name = shownSurface !== null || names.includes(shown) ? shown : names[0];
  const finish = useCallback(() => {
    microShaders.finish();
    surfaces.finish();
  }, [microShaders, surfaces]);
  // oxlint-disable-next-line react/exhaustive-effect-dependencies -- edits become a step when another one is chosen
  useEffect(() => finish, [finish, name]);

  const texts = shownSurface === null ? microShaders : surfaces;
  const key = shownSurface ?? name;
  const problem = texts.problem(key);
  const errors = problem?.entries.filter(({ chunk }) => chunk === key) ?? none;
  return (
    <section className="panel microshaders" aria-label={t('Microshaders')}>
      <ChunkList
        names={names}
        surfaces={surfaces.names}
        current={name}
        uses={uses}
        onChoose={(next) => editor.openMicroShader(next)}
      />
      <div className="chunk">
        {shownSurface === null ? (
          <ChunkBar name={name} onOpen={(next) => editor.openMicroShader(next)} />
        ) : (
          <SurfaceBar name={shownSurface} />
        )}
        <CodeEditor
          name={name}
          text={texts.textOf(key)}
          label={shownSurface === null ? t('Text of the microshader') : t('Text of the surface')}
          problems={errors}
          language={glslLanguage}
          goTo={place?.name === name && place.line > 0 ? place : null}
          onInput={(text) => texts.edit(key, text)}
          onLeave={finish}
        />
        {problem && <ChunkErrors name={key} shown={name} problem={problem} />}
      </div>
      {shownSurface === null ? <ChunkUses name={name} uses={uses} /> : <SurfaceUses name={shownSurface} />}
    </section>
  );
}

const none: readonly never[] = [];
