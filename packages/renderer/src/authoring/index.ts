export { findClaims, type Claim } from './findClaims';
export { formatMicroShader } from '../microshaders/formatMicroShader';
export { parseMicroShaderXML } from '../microshaders/xml/parseMicroShaderXML';
export { formatMicroShaderXML } from './formatMicroShaderXML';
export { microShaderSources } from './microShaderSources';
export { readPixels } from '../three/readPixels';
