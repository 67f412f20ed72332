import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { MicroShaderUses } from '../../microshaders/MicroShaderUses';
import { useEditor } from '../../ui/EditorContext';

/** Dependencies of a microshader, its dependents, and the programs that use it. */
export function ChunkUses({ name, uses }: { name: string; uses: MicroShaderUses }): ReactNode {
  const editor = useEditor();
  const { microShaders } = editor;
  const { registry } = microShaders;
  const { techniques } = editor.viewport.farol;
  const needs = registry.get(name)?.dependencies ?? [];
  const users = microShaders.names.filter((other) => registry.get(other)?.dependencies.includes(name));
  const drawn = uses.techniquesOf(name);
  const viewed = uses.viewsOf(name);
  const programs = [...new Set(uses.programsOf(name))];
  return (
    <aside className="chunk-uses" aria-label={t('Uses of {name}', { name })}>
      <Chunks title={t('Needs')} names={needs} />
      <Chunks title={t('Needed by')} names={users} />
      <h3>{t('Techniques')}</h3>
      {drawn.length === 0 && <p>{uses.isKnown ? t('No program uses it.') : t('Looking…')}</p>}
      <ul>
        {drawn.map((technique) => (
          <li key={technique}>
            <button
              type="button"
              title={t(techniques[technique].help)}
              aria-pressed={editor.viewport.technique === technique}
              onClick={() => editor.attempt(() => void (editor.viewport.technique = technique))}
            >
              {t(techniques[technique].label)}
            </button>
          </li>
        ))}
      </ul>
      {viewed.length > 0 && (
        <>
          <h3>{t('Views')}</h3>
          <p>{viewed.join(', ')}</p>
        </>
      )}
      <h3>{t('Programs on the device')}</h3>
      <p>{programs.length === 0 ? t('None at present.') : programs.join(', ')}</p>
    </aside>
  );
}

/** Microshaders to open, below a title; nothing for none. */
export function Chunks({ title, names }: { title: string; names: readonly string[] }): ReactNode {
  const editor = useEditor();
  if (names.length === 0) return null;
  return (
    <>
      <h3>{title}</h3>
      <ul>
        {names.map((name) => (
          <li key={name}>
            <button type="button" onClick={() => editor.openMicroShader(name)}>
              {name}
            </button>
          </li>
        ))}
      </ul>
    </>
  );
}
