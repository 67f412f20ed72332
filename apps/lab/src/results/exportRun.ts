import { chartFiles } from '../charts/chartFiles';
import { chartPNG } from '../charts/chartPNG';
import { deviceName } from '../words/device';
import type { LabRun } from './LabRun';

export interface RunFile {
  readonly name: string;
  readonly content: Blob;
}

export interface ExportFormat {
  readonly label: string;
  /** Purpose of the file format, one sentence. */
  readonly help: string;
  make(run: LabRun): Promise<RunFile>;
}

function textFormat(
  label: string,
  help: string,
  { extension, type, write }: { extension: string; type: string; write: (run: LabRun) => Promise<string> | string },
): ExportFormat {
  return {
    label,
    help,
    make: async (run) => ({ name: `${fileName(run)}.${extension}`, content: new Blob([await write(run)], { type }) }),
  };
}

function chartsFormat(label: string, help: string, kind: 'svg' | 'png'): ExportFormat {
  return {
    label,
    help,
    async make(run) {
      const files = chartFiles(run).map(async ({ name, svg }) => {
        const content = kind === 'png' ? await chartPNG(svg) : new Blob([svg]);
        return [`${name}.${kind}`, new Uint8Array(await content.arrayBuffer())] as const;
      });
      const { zipSync } = await import('three/addons/libs/fflate.module.js');
      const archive = zipSync(Object.fromEntries(await Promise.all(files)), { level: 0 });
      const content = new Blob([archive as Uint8Array<ArrayBuffer>], { type: 'application/zip' });
      return { name: `${fileName(run)}-${kind}.zip`, content };
    },
  };
}

export const exportFormats: Readonly<Record<string, ExportFormat>> = {
  json: textFormat('JSON', 'Everything, pictures included: the Lab opens it again, on any machine.', {
    ...{ extension: 'json', type: 'application/json' },
    write: (run) => JSON.stringify(run, null, 1),
  }),
  csv: textFormat('CSV', 'A row for each case and competitor, for spreadsheets and scripts.', {
    ...{ extension: 'csv', type: 'text/csv', write: async (run) => (await import('./runCSV')).runCSV(run) },
  }),
  markdown: textFormat('Markdown', 'Tables as text, with all warnings.', {
    ...{
      extension: 'md',
      type: 'text/markdown',
      write: async (run) => (await import('./runMarkdown')).runMarkdown(run),
    },
  }),
  svg: chartsFormat('SVG', 'Every chart as a drawing that can be enlarged, in an archive.', 'svg'),
  png: chartsFormat('PNG', 'Every chart as a picture, in an archive.', 'png'),
};

/** File name made of letters, digits and hyphens: the run's name with the date, or preset, date and device. */
export function fileName({ name, plan, surroundings }: LabRun): string {
  const parts = [
    'farol-lab',
    name || plan.preset,
    surroundings.date.slice(0, 10),
    ...(name ? [] : [deviceName(surroundings.device)]),
  ];
  return parts
    .join('-')
    .toLowerCase()
    .replaceAll(/[^a-z0-9]+/g, '-')
    .replaceAll(/^-|-$/g, '')
    .slice(0, 80);
}
