export { findClaims, type Claim } from '../microshaders/findClaims';
export { formatMicroShader } from '../microshaders/formatMicroShader';
export { parseMicroShaderXML } from '../microshaders/parseMicroShaderXML';
export { formatMicroShaderXML } from './formatMicroShaderXML';
export { microShaderSources } from './microShaderSources';
