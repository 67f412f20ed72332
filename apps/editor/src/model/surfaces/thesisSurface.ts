import { t } from '@farol/editing';
import { parseMicroShaderXML } from '@farol/renderer/authoring';
import { textOfMicroShaders } from '@farol/renderer/surfaces';

/** URL of the thesis's microshaders. */
export const THESIS = 'microshaders/thesis.xml';

/** Fetches the thesis's microshaders. @throws Error (as a rejection) when the server has none */
export async function fetchThesis(): Promise<string> {
  const response = await fetch(THESIS);
  if (!response.ok)
    throw new Error(
      t('{file}: the server answers {status}; serve the folder public/ too.', {
        file: THESIS,
        status: response.status,
      }),
    );
  return response.text();
}

/** Surface made of the thesis's chunks: a Phong material under one light. @see thesis 3.1.2 */
export async function thesisSurface(light: 'directional' | 'point' | 'spot'): Promise<string> {
  const chunks = parseMicroShaderXML(await fetchThesis(), THESIS);
  return textOfMicroShaders(chunks, ['surface', 'light', `light_${light}`, 'phong', 'phong_output']);
}
