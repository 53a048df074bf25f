// @ts-check
// The teacher's notes: what they say of these very data.

import { byId, element, patch } from "../dom.js";
import { kindText, shortList } from "../model/format.js";
import { conflict, pointOnBoundary, regionWithout } from "../model/lesson.js";
import { ONE, Rational, dot } from "../model/rational.js";
import { numberText, said, t } from "../texts.js";

/**
 * What stands in the places of the notes.
 * @param {Lesson} lesson
 * @returns {TextValues}
 */
export function teacherValues(lesson) {
  return {
    readings: lesson.readings.length,
    within: lesson.data.conditions.length,
    planes: lesson.halfPlanes.filter(({ reading }) => reading !== null).length,
    set: kindText(lesson.fps.kind, lesson.fps.vertices.length),
    saved: saved(lesson),
    smaller: smaller(lesson),
  };
}

/**
 * The readings without which the set would be the same.
 * @param {Lesson} lesson
 */
function saved(lesson) {
  if (lesson.fps.kind === "empty") {
    const rows = conflict(lesson).flatMap(({ index }) => lesson.halfPlanes[index].name.row ?? []);
    return t("teacher.saved-empty", { rows: shortList([...new Set(rows)]) });
  }
  const rows = lesson.readings.map(({ row }) => row);
  const needed = rows.filter((row) => lesson.matters.get(row));
  const others = rows.filter((row) => !lesson.matters.get(row));
  // Of two equal readings each one can go, but not both.
  const key = canGoTogether(lesson, others) ? "teacher.saved" : "teacher.saved-in-turn";
  return t(key, { rows: shortList(needed) });
}

/**
 * Whether a set that is not empty is the same without all of these rows.
 * @param {Lesson} lesson
 * @param {number[]} rows
 */
function canGoTogether(lesson, rows) {
  const left = regionWithout(lesson, rows);
  const points = left.vertices.length > 0
    ? left.vertices.map(({ theta }) => theta)
    : left.boundaries.map((index) => pointOnBoundary(lesson.halfPlanes[index], ONE));
  return lesson.halfPlanes
    .filter(({ name }) => name.row !== null && rows.includes(name.row))
    .every(({ a, b }) =>
      points.every((point) => dot(a, point).compare(b) <= 0) &&
      left.rays.every((ray) => dot(a, ray).sign() <= 0) &&
      left.lines.every((line) => dot(a, line).isZero()));
}

/**
 * What happens to the set when all error bounds become smaller.
 * @param {Lesson} lesson
 */
function smaller(lesson) {
  const { fit, sweep } = lesson.data;
  if (lesson.fps.kind === "empty") return t("teacher.smaller-empty");
  if (!sweep?.least || lesson.readings.every(({ epsilon }) => epsilon.isZero())) return t("teacher.smaller-nothing");
  const factor = Rational.parse(sweep.least.exact);
  if (factor.equals(ONE)) return t("teacher.smaller-gone");
  const epsilon = lesson.epsilon === null ? null : fit.minimax?.epsilon;
  const least = epsilon ? `ε = ${numberText(epsilon.decimal)}` : `s = ${numberText(sweep.least.decimal)}`;
  return t(factor.isZero() ? "teacher.smaller-never" : "teacher.smaller", { least });
}

/**
 * The questions of the page with their answers, for whoever teaches.
 * @param {Lesson} lesson
 */
export function drawTeacher(lesson) {
  const answers = lesson.data.questions.flatMap(({ question, answer }) => [
    element("dt", {}, said(question)),
    element("dd", {}, said(answer)),
  ]);
  patch(byId("teacher-answers"), answers);
}
