// @ts-check
// What the engine took a table for, in words: so that no guess goes unsaid.

import { said, t } from "../texts.js";

const DELIMITERS = ["comma", "semicolon", "tab", "space", "pipe"];

/**
 * @param {TableData} notes
 * @returns {string}
 */
export function notesOf({ header, delimiter, decimal, thousands, encoding, blocks, skipped }) {
  const { line, comment, open } = header;
  /** @param {string} what @param {number} count */
  const counted = (what, count) => (count > 0 ? t(`table.${what}`, { count }) : "");
  const named = comment ? "table.names-in-comment" : open ? "table.header-open" : "table.header";
  // JSON has no columns to separate, and keys in the place of a line with names.
  const isJson = delimiter === null && encoding !== null;
  const parts = [
    isJson ? t("table.keys") : line === null ? t("table.no-header") : t(named, { line }),
    delimiter === null ? "" : DELIMITERS.includes(delimiter) ? t(`table.delimiter.${delimiter}`) : t("table.delimiter", { mark: delimiter }),
    isJson ? "" : t(`table.decimal.${decimal}`),
    thousands === null ? "" : t("table.thousands", { mark: thousands }),
    encoding === null || encoding === "UTF-8" ? "" : t("table.encoding", { encoding }),
    blockWords(blocks),
    counted("lines", skipped.lines),
    counted("comments", skipped.comments),
    counted("short-rows", skipped.short_rows),
    counted("long-rows", skipped.long_rows),
  ];
  return t("table.taken", { notes: said({ list: parts.filter((part) => part !== "") }) });
}

/** @param {TableData["blocks"]} blocks */
function blockWords(blocks) {
  if (blocks === null) return "";
  const { total, read, name } = blocks;
  if (read === null) return t("table.all-blocks", { total });
  return name === null ? t("table.block", { total, number: read }) : t("table.named-block", { total, number: read, name });
}
